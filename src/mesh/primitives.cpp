#include "mesh/primitives.h"

#include <cassert>

#include "core/rigid_motion.h"

namespace drape {

TriangleMesh make_grid(const std::array<double, 2>& size, const std::array<int, 2>& points) {
  assert(points[0] >= 2 && points[1] >= 2);
  TriangleMesh mesh;
  for (int j = 0; j < points[1]; ++j)
    for (int i = 0; i < points[0]; ++i) {
      const Vec2 uv(i / double(points[0] - 1), j / double(points[1] - 1));
      mesh.uvs.push_back(uv);
      mesh.positions.emplace_back((uv.x() - 0.5) * size[0], 0, (uv.y() - 0.5) * size[1]);
    }
  for (int j = 0; j + 1 < points[1]; ++j)
    for (int i = 0; i + 1 < points[0]; ++i) {
      const int corner = j * points[0] + i;
      const int diagonal = corner + points[0] + 1;
      mesh.triangles.push_back({corner, corner + points[0], diagonal});
      mesh.triangles.push_back({corner, diagonal, corner + 1});
    }
  mesh.uv_triangles = mesh.triangles;
  return mesh;
}

namespace {

// A right-handed frame: a surface of revolution turns about `axis`, from `side` towards axis x side.
struct Frame {
  Vec3 axis;
  Vec3 side;
};

// One circle of a surface of revolution.
struct Circle {
  Vec3 centre;
  double radius;
};

}  // namespace

static void add_circle(const Frame& frame, const Circle& circle, int segments, TriangleMesh& mesh) {
  const Vec3 other_side = frame.axis.cross(frame.side);
  for (int i = 0; i < segments; ++i) {
    const auto [s, c] = sin_cos_degrees(360.0 * i / segments);
    mesh.positions.push_back(circle.centre + circle.radius * (c * frame.side + s * other_side));
  }
}

// The band of two triangles a segment between the circle that starts at point `lower` and the next circle.
static void add_band(int lower, int segments, TriangleMesh& mesh) {
  const int upper = lower + segments;
  for (int i = 0; i < segments; ++i) {
    const int next = (i + 1) % segments;
    mesh.triangles.push_back({lower + i, lower + next, upper + next});
    mesh.triangles.push_back({lower + i, upper + next, upper + i});
  }
}

// Closed by a pole at each end; the circles go from `bottom` to `top`, along the axis.
static TriangleMesh revolve(const Frame& frame, const Vec3& bottom, const std::vector<Circle>& circles,
                            const Vec3& top, int segments) {
  TriangleMesh mesh;
  mesh.positions.push_back(bottom);
  for (const Circle& circle : circles) add_circle(frame, circle, segments, mesh);
  mesh.positions.push_back(top);

  const int last = static_cast<int>(mesh.positions.size()) - 1;
  for (int i = 0; i < segments; ++i) mesh.triangles.push_back({0, 1 + (i + 1) % segments, 1 + i});
  for (int lower = 1; lower + segments < last; lower += segments) add_band(lower, segments, mesh);
  for (int i = 0; i < segments; ++i)
    mesh.triangles.push_back({last - segments + i, last - segments + (i + 1) % segments, last});
  return mesh;
}

TriangleMesh make_sphere(double radius, int segments, int rings) {
  assert(segments >= 3 && rings >= 2);
  const Frame frame{Vec3::UnitY(), Vec3::UnitX()};
  std::vector<Circle> circles;
  for (int ring = 1; ring < rings; ++ring) {
    const auto [s, c] = sin_cos_degrees(180.0 * ring / rings);
    circles.push_back({-c * radius * frame.axis, s * radius});
  }
  return revolve(frame, -radius * frame.axis, circles, radius * frame.axis, segments);
}

// The coordinate axis furthest from `axis` makes the best conditioned side.
static Frame frame_along(const Vec3& axis) {
  int furthest = 0;
  axis.cwiseAbs().minCoeff(&furthest);
  return {axis, Vec3(Vec3::Unit(furthest)).cross(axis).normalized()};
}

TriangleMesh make_capsule(const Vec3& a, const Vec3& b, double radius, int segments, int rings) {
  assert(segments >= 3 && rings >= 1);
  const double length = (b - a).norm();
  const Frame frame = frame_along(length > 0 ? Vec3((b - a) / length) : Vec3(Vec3::UnitY()));
  std::vector<Circle> circles;
  for (int ring = 1; ring <= rings; ++ring) {
    const auto [s, c] = sin_cos_degrees(90.0 * ring / rings);
    circles.push_back({a - c * radius * frame.axis, s * radius});
  }
  for (int ring = length > 0 ? 0 : 1; ring < rings; ++ring) {
    const auto [s, c] = sin_cos_degrees(90.0 * ring / rings);
    circles.push_back({b + s * radius * frame.axis, c * radius});
  }
  return revolve(frame, a - radius * frame.axis, circles, b + radius * frame.axis, segments);
}

TriangleMesh make_cylinder(double radius, double height, int segments) {
  assert(segments >= 3);
  const Frame frame{Vec3::UnitY(), Vec3::UnitX()};
  const Vec3 top = 0.5 * height * frame.axis;
  return revolve(frame, -top, {{-top, radius}, {top, radius}}, top, segments);
}

TriangleMesh make_box(const Vec3& size) {
  TriangleMesh mesh;
  // Bit k of a point's number says on which side of axis k it is.
  for (int corner = 0; corner < 8; ++corner)
    mesh.positions.push_back(
        0.5 * size.cwiseProduct(Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

}  // namespace drape
