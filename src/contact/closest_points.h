#pragma once

#include <array>

#include "core/vector.h"

namespace drape {

enum class PairKind { point_triangle, edge_edge };

// Four points: a point and a triangle's three, or two edges' two each. The first side is the point or the
// first edge.
using FourPoints = std::array<Vec3, 4>;

// The closest points of the two sides. `weights` are barycentric, the second side's negative, so that
// sum weights_i x_i leads from the second side's closest point to the first's, and their sum is 0.
struct ClosestPoints {
  std::array<double, 4> weights;
  Vec3 difference;    // sum weights_i x_i
  double distance;    // its length, in metres
  bool inside_edges;  // edge-edge: both closest points lie strictly between the ends
};

// Ericson 2005, Real-Time Collision Detection, 5.1.5.
ClosestPoints closest_point_triangle(const FourPoints& x);
// Ericson 2005, 5.1.9; parallel and degenerate edges included.
ClosestPoints closest_edge_edge(const FourPoints& x);

ClosestPoints closest_points(PairKind kind, const FourPoints& x);

// The number of points on the first side.
constexpr int first_side(PairKind kind) { return kind == PairKind::point_triangle ? 1 : 2; }

}  // namespace drape
