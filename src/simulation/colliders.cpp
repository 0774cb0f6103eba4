#include "simulation/colliders.h"

#include <algorithm>

#include "mesh/primitives.h"
#include "mesh/topology.h"

namespace drape {
namespace {

ColliderPrimitives mesh_primitives(const TriangleMesh& mesh) {
  ColliderPrimitives primitives{mesh.positions, {}, mesh.triangles, 0};
  const Topology topology = build_topology(static_cast<int>(mesh.positions.size()), mesh.triangles);
  for (const Edge& edge : topology.edges) primitives.edges.push_back(edge.vertices);
  return primitives;
}

struct MakePrimitives {
  ColliderPrimitives operator()(const PlaneShape&) const { return {}; }
  ColliderPrimitives operator()(const SphereShape& sphere) const {
    return {{Vec3::Zero()}, {}, {}, sphere.radius};
  }
  ColliderPrimitives operator()(const BoxShape& box) const { return mesh_primitives(make_box(box.size)); }
  ColliderPrimitives operator()(const CylinderShape& cylinder) const {
    return mesh_primitives(make_cylinder(cylinder.radius, cylinder.height, cylinder_segments));
  }
  ColliderPrimitives operator()(const CapsuleShape& capsule) const {
    const Vec3 half(0, 0.5 * capsule.length, 0);
    return {{-half, half}, {{0, 1}}, {}, capsule.radius};
  }
  ColliderPrimitives operator()(const MeshShape& shape) const { return mesh_primitives(shape.mesh); }
};

}  // namespace

ColliderPrimitives collider_primitives(const ColliderShape& shape) {
  return std::visit(MakePrimitives{}, shape);
}

bool deforms(const ColliderInput& collider) {
  const MeshShape* mesh = std::get_if<MeshShape>(&collider.shape);
  return mesh != nullptr && !mesh->shapes.empty();
}

static std::vector<Vec3> shape_at(const MeshShape& mesh, double time) {
  const double last = static_cast<double>(mesh.shapes.size() - 1);
  const double place = std::clamp((time - mesh.first_time) / mesh.interval, 0.0, last);
  const std::size_t before = static_cast<std::size_t>(place);
  const std::size_t after = std::min(before + 1, mesh.shapes.size() - 1);
  std::vector<Vec3> points = mesh.shapes[before];
  const double share = place - static_cast<double>(before);
  for (std::size_t v = 0; v < points.size(); ++v) points[v] += share * (mesh.shapes[after][v] - points[v]);
  return points;
}

std::vector<Vec3> collider_points(const ColliderInput& collider, double time) {
  std::vector<Vec3> points = deforms(collider) ? shape_at(std::get<MeshShape>(collider.shape), time)
                                               : collider_primitives(collider.shape).points;
  const RigidPose pose = pose_at(collider.motion, time);
  for (Vec3& point : points) point = pose(point);
  return points;
}

double largest_shape_lag(const std::vector<ColliderInput>& colliders, double time,
                         const std::vector<Vec3>& points) {
  if (std::none_of(colliders.begin(), colliders.end(), deforms)) return 0;
  double largest = 0;
  auto point = points.begin();
  for (const ColliderInput& collider : colliders) {
    const std::vector<Vec3> aims = collider_points(collider, time);
    for (const Vec3& aim : aims) {
      if (deforms(collider)) largest = std::max(largest, (*point - aim).norm());
      ++point;
    }
  }
  return largest;
}

RigidPose collider_pose(const ColliderInput& collider, double time) {
  return deforms(collider) ? RigidPose{} : pose_at(collider.motion, time);
}

}  // namespace drape
