#include "certificate/solid.h"

#include <algorithm>
#include <limits>

#include "certificate/box_tree.h"
#include "certificate/triangle_distance.h"

namespace drape {

ConvexSolid convex_solid(const TriangleMesh& mesh) {
  ConvexSolid solid;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& corner = mesh.positions[a];
    const Vec3 normal = (mesh.positions[b] - corner).cross(mesh.positions[c] - corner).normalized();
    solid.planes.push_back({normal, normal.dot(corner)});
  }
  return solid;
}

static double depth_of_point(const ConvexSolid& solid, const Vec3& point) {
  double depth = std::numeric_limits<double>::infinity();
  for (const Plane& plane : solid.planes) {
    depth = std::min(depth, plane.offset - plane.normal.dot(point));
    if (!(depth > 0)) return 0;
  }
  return solid.planes.empty() ? 0 : depth;
}

namespace {

struct Depth {
  const TrianglePoints& triangle;

  double operator()(const HalfSpace&) const {
    return std::max(0.0, -std::min({triangle[0].y(), triangle[1].y(), triangle[2].y()}));
  }
  // Distances are dear, and most triangles are far away.
  double operator()(const RoundedSegment& solid) const {
    const BoundingBox box{solid.from.cwiseMin(solid.to), solid.from.cwiseMax(solid.to)};
    if (squared_box_distance(box, box_of(triangle)) >= solid.radius * solid.radius) return 0;
    return std::max(0.0, solid.radius - segment_triangle_distance(solid.from, solid.to, triangle));
  }
  double operator()(const ConvexSolid& solid) const {
    return std::max({depth_of_point(solid, triangle[0]), depth_of_point(solid, triangle[1]),
                     depth_of_point(solid, triangle[2])});
  }
};

}  // namespace

double depth_in(const Solid& solid, const TrianglePoints& triangle) {
  const bool is_finite = triangle[0].allFinite() && triangle[1].allFinite() && triangle[2].allFinite();
  return is_finite ? std::visit(Depth{triangle}, solid) : 0;
}

}  // namespace drape
