#include "contact/contact_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape {

std::array<int, 2> pair_bodies(const ContactGeometry& geometry, PairKind kind,
                               const std::array<int, 4>& vertices) {
  return {geometry.vertex_body[vertices[0]], geometry.vertex_body[vertices[first_side(kind)]]};
}

// A bound of how near the sides are to each other, from one of each's points and how far its others are.
static double least_rest_distance(PairKind kind, const FourPoints& x) {
  const int second = first_side(kind);
  const double first_span = (x[second - 1] - x[0]).norm();
  const double second_span = std::max((x[second + 1] - x[second]).norm(), (x[3] - x[second]).norm());
  return (x[second] - x[0]).norm() - first_span - second_span;
}

static double thickness_within(const ContactGeometry& geometry, PairKind kind,
                               const std::array<int, 4>& vertices, double thickness) {
  constexpr double share = 2 / std::numbers::pi;
  const FourPoints rest = gather(geometry.rest_positions, vertices);
  if (share * least_rest_distance(kind, rest) > thickness)
    return thickness;  // most that meet: a cheap answer
  return std::min(thickness, share * closest_points(kind, rest).distance);
}

double pair_thickness(const ContactGeometry& geometry, PairKind kind, const std::array<int, 4>& vertices) {
  const auto [a, b] = pair_bodies(geometry, kind, vertices);
  if (a == b) return thickness_within(geometry, kind, vertices, geometry.bodies[a].thickness);
  return largest_thickness(geometry, a, b);
}

double largest_thickness(const ContactGeometry& geometry, int body_a, int body_b) {
  const ContactBody &first = geometry.bodies[body_a], &second = geometry.bodies[body_b];
  if (first.is_cloth && second.is_cloth) return 0.5 * (first.thickness + second.thickness);
  return first.thickness + second.thickness;
}

double pair_radius(const ContactGeometry& geometry, int body_a, int body_b) {
  return geometry.bodies[body_a].radius + geometry.bodies[body_b].radius;
}

double pair_friction(const ContactGeometry& geometry, int body_a, int body_b) {
  return std::sqrt(geometry.bodies[body_a].friction * geometry.bodies[body_b].friction);
}

}  // namespace drape
