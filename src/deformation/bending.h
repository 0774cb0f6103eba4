#pragma once

#include <array>
#include <vector>

#include "deformation/sheet.h"
#include "deformation/sweep_order.h"

namespace drape {

// Outer-corner clusters (section 4.1, Fig. 2): the corners across a triangle's three edges, and its own three.
// Six points fix one quadratic surface, whose curvature is what bends: with p_i the rest points in the triangle's
// plane, three combinations
//   r_j = sum_i q_ji x_i   with   sum_i q_ji = 0,  sum_i q_ji p_i = 0
// are what no affine map of the rest shape explains (the residual of the linear matching of MHTG05, 4.2), and so no
// stretch, shear or rigid motion changes them; they grow with the first power of a fold's angle. The potential is
// 1/2 A k^T D k, with k = G^-1 r the second derivatives of that surface: exact for every cylinder and every mesh,
// unlike energies of single edges, which weigh a fold by how the mesh is cut. Where corners are missing (a boundary,
// or two that coincide), fewer combinations are left, and the curvature that they leave open is free of moments:
// the natural boundary condition. A curved rest shape has r_j = rho_j n along the normal that fits best.
struct BendingStage {
  SweepOrder order;
  std::vector<IndexRow> corners;   // 6 a row: own, then outer
  std::vector<LaneRow> weights;    // 18 a row: q'_j of point i at 6 j + i. K = L L^T is the implicit step, q' = L^T q
  std::vector<LaneRow> rest;       // 3 a row: rho'_j, where `curved`
  bool curved = false;
};
// Rows where a step starts: the residuals; where curved, then the triangle's edges too.
inline std::size_t bending_base_rows(const BendingStage& stage) { return stage.curved ? 15 : 9; }

// Own and outer corners of a triangle: -1 for those that are missing, coincide, or lie so that the others say more.
std::array<int, 6> bending_corners(const Sheet& sheet, int triangle);

// `duration_squared` in s2 as in MembraneTerms: h2 for a pull, damping times h for damping.
struct BendingTerms {
  std::vector<double> durations_squared;  // of each material, s2
  bool rest_curvature = true;             // false: rates have none
};
BendingStage build_bending(const Sheet& sheet, const std::vector<int>& patches,
                           const std::vector<double>& inverse_masses, const BendingTerms& terms);

void load_bending(const BendingStage& stage, const std::vector<Vec3>& start, std::vector<LaneRow>& base);

// One Gauss-Seidel sweep of implicit steps, as pull_membrane. Keeps both momenta.
void pull_bending(const BendingStage& stage, const std::vector<LaneRow>& base, std::vector<Point4>& offsets);

// The same for velocities: takes away what rates of bending lose by viscosity.
void damp_bending(const BendingStage& stage, std::vector<Point4>& velocities);

}  // namespace drape
