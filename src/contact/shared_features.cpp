#include "contact/shared_features.h"

#include <algorithm>

namespace drape {
namespace {

// A point, and the triangle that it is closest to.
struct Neighbourhood {
  const ContactGeometry& geometry;
  const Incidence& triangles_at;  // vertices
  const StepMotion& motion;
  const ContactPair& pair;
  const Vec3& difference;  // from the triangle to the point, at this time
  double time;             // share of the step

  int point() const { return pair.vertices[0]; }
  Triangle triangle() const { return {pair.vertices[1], pair.vertices[2], pair.vertices[3]}; }
  Vec3 place(int v) const { return motion.start[v] + time * (motion.end[v] - motion.start[v]); }
};

bool contains(const Triangle& triangle, int v) {
  return std::find(triangle.begin(), triangle.end(), v) != triangle.end();
}

// Calls visit(triangle) for those at vertex v that can make a contact with the point, in order, until it
// returns true, and returns whether it did.
template <typename Visit>
bool any_at(const Neighbourhood& around, int v, const Visit& visit) {
  const auto& [begin, slots] = around.triangles_at;
  for (std::size_t i = begin[v]; i < begin[v + 1]; ++i) {
    const Triangle& triangle = around.geometry.triangles[slots[i] / 3];
    if (!contains(triangle, around.point()) && visit(triangle)) return true;
  }
  return false;
}

// Whether who goes this way comes nearer to what lies beyond the `difference`, and rises by more than
// `margin`, the sine of an angle.
bool rises(const Vec3& direction, const Vec3& difference, double margin) {
  const double along = direction.dot(difference);
  return along > 0 && along * along > margin * margin * direction.squaredNorm() * difference.squaredNorm();
}

// Whether who goes from the closest point in this direction plainly comes nearer to the point.
bool leads_nearer(const Neighbourhood& around, const Vec3& direction) {
  constexpr double margin = 0.05;
  return rises(direction, around.difference, margin);
}

// From the edge between a and b into a triangle whose third corner is `other`; zero where that lies on the
// edge.
Vec3 inwards(const Neighbourhood& around, int a, int b, int other) {
  constexpr double flat = 1e-9;  // of the side: less is rounding
  const Vec3 edge = around.place(b) - around.place(a), side = around.place(other) - around.place(a);
  const Vec3 height = side - edge.dot(side) / edge.squaredNorm() * edge;
  return height.squaredNorm() > flat * flat * side.squaredNorm() ? height : Vec3::Zero();
}

std::array<int, 4> with_point(const Neighbourhood& around, const Triangle& triangle) {
  return {around.point(), triangle[0], triangle[1], triangle[2]};
}

// Whether the pair's own triangle bends up from the neighbour like the other side of a valley. A point that
// the neighbour alone holds comes nearer to one that bends up less by a quarter of its way in the step at
// most.
bool bends_up_from(const Neighbourhood& around, const Triangle& neighbour) {
  constexpr double margin = 0.25;
  const auto [p, a, b, c] = with_point(around, neighbour);
  const Vec3 point = around.place(p);
  const Vec3 above =
      closest_point_triangle({point, around.place(a), around.place(b), around.place(c)}).difference;
  const Triangle own = around.triangle();
  return std::any_of(own.begin(), own.end(), [&](int v) {
    return !contains(neighbour, v) && rises(around.place(v) - (point - around.difference), above, margin);
  });
}

// Whether the neighbour, or one to which it leaves the point in turn, keeps as much: if the pair meets on the
// way, from the start.
bool holds_as_much(const Neighbourhood& around, const Triangle& neighbour) {
  const std::array<int, 4> vertices = with_point(around, neighbour);
  if (pair_thickness(around.geometry, around.pair.kind, vertices) < around.pair.thickness) return false;
  return around.time == 0 ||
         closest_point_triangle(gather(around.motion.start, vertices)).distance <= around.pair.thickness;
}

// Whether the contact is left to one of the triangles at v for which `shares` holds: one that comes before
// the pair's (if it is there from the start), or one for which is_nearer(it).
template <typename Shares, typename IsNearer>
bool is_left(const Neighbourhood& around, int v, const Shares& shares, const IsNearer& is_nearer) {
  const bool first_counts = around.time == 0;
  bool is_before = true;
  return any_at(around, v, [&](const Triangle& triangle) {
    if (triangle == around.triangle()) {
      is_before = false;
      return false;
    }
    return shares(triangle) && ((first_counts && is_before) || is_nearer(triangle)) &&
           holds_as_much(around, triangle) && !bends_up_from(around, triangle);
  });
}

// The closest point lies on the edge between a and b.
bool is_left_on_edge(const Neighbourhood& around, int a, int b) {
  return is_left(
      around, a, [&](const Triangle& triangle) { return contains(triangle, b); },
      [&](const Triangle& triangle) {
        const int other = triangle[0] + triangle[1] + triangle[2] - a - b;
        return leads_nearer(around, inwards(around, a, b, other));
      });
}

// The closest point is corner a.
bool is_left_at_corner(const Neighbourhood& around, int a) {
  return is_left(
      around, a, [](const Triangle&) { return true; },
      [&](const Triangle& triangle) {
        return std::any_of(triangle.begin(), triangle.end(), [&](int v) {
          return v != a && leads_nearer(around, around.place(v) - around.place(a));
        });
      });
}

}  // namespace

bool is_left_to_neighbour(const ContactGeometry& geometry, const Incidence& triangles_at,
                          const StepMotion& motion, const ContactPair& pair, const ClosestPoints& closest,
                          double time) {
  if (pair.kind != PairKind::point_triangle || pair.radius > 0) return false;
  const Neighbourhood around{geometry, triangles_at, motion, pair, closest.difference, time};
  const auto on = [&](int i) { return closest.weights[i] != 0; };
  const auto [p, a, b, c] = pair.vertices;
  if (on(1) && on(2)) return !on(3) && is_left_on_edge(around, a, b);
  if (on(2) && on(3)) return is_left_on_edge(around, b, c);
  if (on(3) && on(1)) return is_left_on_edge(around, c, a);
  return is_left_at_corner(around, on(1) ? a : on(2) ? b : c);
}

}  // namespace drape
