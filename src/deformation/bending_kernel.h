#pragma once

#include "deformation/bending.h"
#include "deformation/membrane_kernel.h"

// The arithmetic of bending.h for one row, as eight lanes (Number = Lanes) or one of them (float).
namespace drape {

template <typename Number>
struct BendingCorners {
  LanePoint<Number> point[6];
};

template <typename Number>
BendingCorners<Number> gather_corners(const BendingStage& stage, std::size_t row, const LaneAccess<Number>& access,
                                      const Point4* points) {
  BendingCorners<Number> corners;
  for (std::size_t i = 0; i < 6; ++i) corners.point[i] = access.gather(points, stage.corners[6 * row + i]);
  return corners;
}

template <typename Number>
LaneVec3<Number> residual(const LaneRow* weights, const LaneAccess<Number>& access,
                          const BendingCorners<Number>& corners, LaneVec3<Number> sum) {
  for (int i = 0; i < 6; ++i) sum = multiply_add(access.load(weights[i]), corners.point[i].p, sum);
  return sum;
}

// x_i -= w_i sum_j q'_ji r'_j.
template <typename Number>
void relax_residuals(const LaneRow* weights, const LaneAccess<Number>& access, const LaneVec3<Number> (&r)[3],
                     BendingCorners<Number>& corners) {
  for (int i = 0; i < 6; ++i) {
    LaneVec3<Number> pull = access.load(weights[i]) * r[0];
    pull = multiply_add(access.load(weights[6 + i]), r[1], pull);
    pull = multiply_add(access.load(weights[12 + i]), r[2], pull);
    corners.point[i].p = subtract_product(corners.point[i].w, pull, corners.point[i].p);
  }
}

template <typename Number>
void scatter_corners(const BendingStage& stage, std::size_t row, const LaneAccess<Number>& access,
                     const BendingCorners<Number>& corners, Point4* points) {
  for (std::size_t i = 0; i < 6; ++i) access.scatter(points, stage.corners[6 * row + i], corners.point[i]);
}

// What the rest shape keeps of the residuals: rho'_j along the unit vector n that fits all three best, on the side
// of the triangle's normal. Any other n would exert a torque.
template <typename Number>
void subtract_rest(const BendingStage& stage, std::size_t row, const LaneAccess<Number>& access,
                   const LaneRow* base_edges, const BendingCorners<Number>& corners, LaneVec3<Number> (&r)[3]) {
  const LaneRow* rest = &stage.rest[3 * row];
  LaneVec3<Number> n = access.load(rest[0]) * r[0];
  n = multiply_add(access.load(rest[1]), r[1], n);
  n = multiply_add(access.load(rest[2]), r[2], n);
  const LaneVec3<Number> e1 = load_vector(access, base_edges) + (corners.point[1].p - corners.point[0].p);
  const LaneVec3<Number> e2 = load_vector(access, base_edges + 3) + (corners.point[2].p - corners.point[0].p);
  const Number outward = dot(n, cross(e1, e2)), length_squared = dot(n, n);
  const Number unsigned_scale = Number(1) / square_root(length_squared);
  const Number scale = where_positive(length_squared, where_positive(outward, unsigned_scale, -unsigned_scale), Number(0));
  for (int j = 0; j < 3; ++j) r[j] = subtract_product(access.load(rest[j]) * scale, n, r[j]);
}

template <typename Number>
[[gnu::flatten]] void pull_bending_row(const BendingStage& stage, const std::vector<LaneRow>& base, std::size_t row,
                      const LaneAccess<Number>& access, Point4* offsets) {
  const LaneRow* weights = &stage.weights[18 * row];
  const LaneRow* start = &base[bending_base_rows(stage) * row];
  BendingCorners<Number> corners = gather_corners(stage, row, access, offsets);
  LaneVec3<Number> r[3];
  for (int j = 0; j < 3; ++j)
    r[j] = residual(weights + 6 * j, access, corners, load_vector(access, start + 3 * j));
  if (stage.curved) subtract_rest(stage, row, access, start + 9, corners, r);
  relax_residuals(weights, access, r, corners);
  scatter_corners(stage, row, access, corners, offsets);
}

template <typename Number>
[[gnu::flatten]] void damp_bending_row(const BendingStage& stage, std::size_t row, const LaneAccess<Number>& access,
                      Point4* velocities) {
  const LaneRow* weights = &stage.weights[18 * row];
  const Number zero(0);
  BendingCorners<Number> corners = gather_corners(stage, row, access, velocities);
  LaneVec3<Number> r[3];
  for (int j = 0; j < 3; ++j) r[j] = residual(weights + 6 * j, access, corners, {zero, zero, zero});
  relax_residuals(weights, access, r, corners);
  scatter_corners(stage, row, access, corners, velocities);
}

}  // namespace drape
