#pragma once

#include <array>
#include <vector>

#include "deformation/sheet.h"
#include "deformation/split_points.h"
#include "deformation/sweep_order.h"

namespace drape {

// Outer-corner clusters (section 4.1, Fig. 2): the corners across a triangle's three edges, and its own
// three. Six points fix one quadratic surface, whose curvature is what bends: with p_i the rest points in the
// triangle's plane, three combinations
//   r_j = sum_i q_ji x_i   with   sum_i q_ji = 0,  sum_i q_ji p_i = 0
// are what no affine map of the rest shape explains (the residual of the linear matching of MHTG05, 4.2), and
// so no stretch, shear or rigid motion changes them; they grow with the first power of a fold's angle. The
// potential is 1/2 A k^T D k, with k = G^-1 r the second derivatives of that surface: exact for every
// cylinder and every mesh, unlike energies of single edges, which weigh a fold by how the mesh is cut. Where
// corners are missing (a boundary, or two that coincide), fewer combinations are left, and the curvature that
// they leave open is free of moments: the natural boundary condition. A curved rest shape has r_j = rho_j n
// along the normal that fits best.
//
// As a basis of the combinations each outer corner serves with the own three: r_j = x_j - x_a - s_j (x_b -
// x_a)
// - t_j (x_c - x_a), with a, b, c the own corners and (s_j, t_j) where corner j lies in their affine
// coordinates. With K = L L^T the implicit step, the kernel has r' = L^T r, and moves by L r'.
struct BendingStage {
  SweepOrder order;
  std::vector<IndexRow> corners;     // 6 a row: own, then outer
  std::vector<LaneRow> coordinates;  // 6 a row: s_j, then t_j
  std::vector<LaneRow> steps;        // 6 a row: L (11 21 22 31 32 33), root of kg
  std::vector<LaneRow> dampings;     // 6 a row: the same of viscous moments
  std::vector<LaneRow> rest;         // 3 a row: rho'_j, where `curved`
  bool curved = false;
};
constexpr std::size_t coordinate_rows = 6, bending_step_rows = 6;
// Rows where a step starts: the r_j; where curved, then the triangle's edges too.
inline std::size_t bending_base_rows(const BendingStage& stage) { return stage.curved ? 15 : 9; }

// Own and outer corners of a triangle: -1 for those that are missing, coincide, or lie so that the others say
// more.
std::array<int, 6> bending_corners(const Sheet& sheet, int triangle);

// Durations squared, of each material in s2, as in MembraneTerms: h2 for a pull, damping times h for damping.
BendingStage build_bending(const Sheet& sheet, const std::vector<int>& patches,
                           const std::vector<double>& inverse_masses, double pull_duration_squared,
                           const std::vector<double>& damping_durations_squared);

void load_bending(const BendingStage& stage, const SplitPoints& start, std::vector<LaneRow>& base);

// One Gauss-Seidel sweep of implicit steps, as pull_membrane. Keeps both momenta.
void pull_bending(const BendingStage& stage, const std::vector<LaneRow>& base, std::vector<Point4>& offsets);

// The same for velocities: takes away what rates of bending lose by viscosity.
void damp_bending(const BendingStage& stage, std::vector<Point4>& velocities);

}  // namespace drape
