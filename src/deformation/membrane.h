#pragma once

#include <vector>

#include "deformation/sheet.h"
#include "deformation/split_points.h"
#include "deformation/sweep_order.h"

namespace drape {

// Own-triangle clusters: the corners of each triangle, which section 4.1 of the paper leaves out (outer
// corners alone fall apart into lattices that do not hold each other). The rest triangle is rotated to match
// its corners as in Appendix A; the goals are the rest triangle so rotated and, like the linear match of
// MHTG05, strained by what the material lets remain of the strain: the implicit step of the membrane's
// potential
//   sum m |dx|2 / (2 h2) + 1/2 A e^T C e
// with e the strains in the matched frame. So stretch and shear have stiffnesses of their own with units, and
// no step and no stiffness overshoots. Points of inverse mass 0 stay.
struct MembraneStage {
  SweepOrder order;
  std::vector<IndexRow> corners;  // 3 a row
  std::vector<LaneRow> shapes;    // a row: see MembraneShape
  std::vector<LaneRow> stresses;  // 6 a row: the symmetric K of stress = K e (11 12 13 22 23 33), kg m
  std::vector<LaneRow> dampings;  // 6 a row: the same of viscous stresses
};

// Rows of constants of eight triangles, in the order that they are stored in.
struct MembraneShape {
  static constexpr std::size_t k1 = 0, k2 = 1;  // of MatchConstants
  static constexpr std::size_t inverse_shape =
      2;  // 4: rows of the inverse of the rest edges in the matched frame, 1/m
  static constexpr std::size_t count = 6;
};
constexpr std::size_t stress_rows = 6;
// Rows of the edges of a triangle, from its first corner to the second and the third, where a step starts.
constexpr std::size_t membrane_base_rows = 6;

// How much of C each triangle keeps for itself, and which implicit step its pull is.
struct MembraneTerms {
  std::vector<Mat3> tensors;  // of each triangle, N/m, in its matched frame
  double duration_squared;    // s2: h2 for a pull; tau h for damping
};

// Frame and rest edges of a triangle: the axes are those of MatchConstants.
struct RestFrame {
  Vec2 edge1, edge2;  // m
  Vec2 warp;          // unit vector
  double k1, k2;      // of MatchConstants
  double area;        // m2
};
RestFrame rest_frame(const Sheet& sheet, int triangle, const std::vector<double>& masses);

MembraneStage build_membrane(const Sheet& sheet, const std::vector<int>& patches,
                             const std::vector<double>& weights, const std::vector<double>& inverse_masses,
                             const MembraneTerms& pull, const MembraneTerms& damping);

// The rows of edges where a step starts; what offsets are relative to.
void load_membrane(const MembraneStage& stage, const SplitPoints& start, std::vector<LaneRow>& base);

// One Gauss-Seidel sweep over x = start + offset; w of an offset is the point's inverse mass.
void pull_membrane(const MembraneStage& stage, const std::vector<LaneRow>& base,
                   std::vector<Point4>& offsets);

// Takes from the velocities what the rates of strain lose by viscosity, in the frames where the step starts.
// Keeps rigid motion of each triangle, as the damping of Rivers and James 2007 does.
void damp_membrane(const MembraneStage& stage, const std::vector<LaneRow>& base,
                   std::vector<Point4>& velocities);

}  // namespace drape
