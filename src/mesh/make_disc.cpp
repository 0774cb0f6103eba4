#include <cassert>
#include <cmath>
#include <numbers>

#include "core/rigid_motion.h"
#include "mesh/primitives.h"

// A disc of rings about its centre. A lattice would favour its own directions in how a cloth folds: six times
// round the disc for triangles, four times for a mapped square. Rings have no direction of their own where
// the numbers of their points have no common divisor and each is turned against the next.
namespace drape {
namespace {

// The points of a ring, one after another in the mesh; the centre is the ring of one point.
struct Ring {
  int first;
  int count;
  int operator[](int i) const { return first + i % count; }
};

// Rings as far apart as the rows of equilateral triangles, and points as far apart as their sides.
int count_rings(double radius, double edge) {
  return std::max(2, static_cast<int>(std::lround(radius / (edge * std::numbers::sqrt3 / 2))));
}

int count_ring_points(double radius, double edge) {
  return static_cast<int>(std::lround(2 * std::numbers::pi * radius / edge));
}

Ring add_ring(double radius, int count, double phase, TriangleMesh& mesh) {
  const Ring ring{static_cast<int>(mesh.positions.size()), count};
  for (int i = 0; i < count; ++i) {
    const auto [s, c] = sin_cos_degrees(phase + 360.0 * i / count);
    mesh.positions.emplace_back(radius * c, 0, -radius * s);  // about +y, from +x towards -z
  }
  return ring;
}

int nearest(const Ring& ring, const Vec3& point, const TriangleMesh& mesh) {
  const auto distance = [&](int i) { return (mesh.positions[ring[i]] - point).squaredNorm(); };
  int best = 0;
  for (int i = 1; i < ring.count; ++i)
    if (distance(i) < distance(best)) best = i;
  return best;
}

// Goes round both rings at once, and each time over the shorter of the two diagonals.
void join(const Ring& inner, const Ring& outer, TriangleMesh& mesh) {
  const int start = nearest(outer, mesh.positions[inner[0]], mesh);
  const auto distance = [&](int a, int b) { return (mesh.positions[a] - mesh.positions[b]).squaredNorm(); };
  const int inner_steps = inner.count > 1 ? inner.count : 0;
  for (int i = 0, j = 0; i < inner_steps || j < outer.count;) {
    const int from = inner[i], to = outer[start + j];
    const int next_from = inner[i + 1], next_to = outer[start + j + 1];
    const bool go_outside =
        i == inner_steps || (j < outer.count && distance(from, next_to) <= distance(next_from, to));
    mesh.triangles.push_back({from, to, go_outside ? next_to : next_from});
    go_outside ? ++j : ++i;
  }
}

void add_flat_uvs(double diameter, TriangleMesh& mesh) {
  for (const Vec3& p : mesh.positions) mesh.uvs.emplace_back(p.x() / diameter + 0.5, p.z() / diameter + 0.5);
  mesh.uv_triangles = mesh.triangles;
}

}  // namespace

TriangleMesh make_disc(double diameter, double edge) {
  assert(edge > 0 && edge <= diameter / 4);
  constexpr double golden_angle = 137.50776405003785;  // degrees; its multiples never come near each other
  const double radius = diameter / 2;
  const int rings = count_rings(radius, edge);
  TriangleMesh mesh;
  Ring inner = add_ring(0, 1, 0, mesh);
  for (int k = 1; k <= rings; ++k) {
    const double ring_radius = radius * k / rings;
    const Ring outer = add_ring(ring_radius, count_ring_points(ring_radius, edge), k * golden_angle, mesh);
    join(inner, outer, mesh);
    inner = outer;
  }
  add_flat_uvs(diameter, mesh);
  return mesh;
}

double count_disc_points(double diameter, double edge) {
  const double rings = diameter / (edge * std::numbers::sqrt3);
  return 1 + std::numbers::pi * diameter / edge * (rings + 1) / 2;
}

}  // namespace drape
