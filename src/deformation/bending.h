#pragma once

#include <array>
#include <vector>

#include "deformation/coloring.h"
#include "deformation/sheet.h"

namespace drape {

// Bending as linear matching (MHTG05, 4.2) of the four points of two neighbour triangles. Four points whose
// rest shape is flat fit an affine image of it but for one residual vector,
//   r = sum c_i x_i   with   sum c_i = 0,  sum c_i p_i = 0   (p_i the unfolded rest points),
// which no stretch, shear or rigid motion changes, and which grows with the first power of the dihedral
// angle: |r| is the edge's length times 2 sin(theta / 2). The potential 1/2 k (|r| - r0)2 with k = 3 B / (A1
// + A2) is the quadratic bending energy of flexural rigidity B (Bergou et al. 2006, A Quadratic Bending Model
// for Inextensible Surfaces). Pulling along c_i keeps linear and angular momentum exactly, since c is
// orthogonal to affine images.
struct Hinge {
  std::array<int, 4> vertices;    // the edge's two, then the two across
  std::array<double, 4> weights;  // c_i
  double rest_residual;           // r0: 0 where the rest shape is flat
  double stiffness;               // k in N/m
  double damping;                 // 1/s
};

struct HingeStage {
  std::vector<Hinge> hinges;  // colour by colour
  std::vector<std::size_t> color_begin;
};

HingeStage build_hinges(const Sheet& sheet);

// One Gauss-Seidel sweep of implicit steps. Points of inverse mass 0 stay.
void pull_hinges(const HingeStage& stage, const std::vector<double>& inverse_masses, double step,
                 std::vector<Vec3>& x);

// Takes away the share d h / (1 + d h), d the damping, of each hinge's rate of bending; keeps both momenta,
// and every velocity of rigid or in-plane motion.
void damp_bending(const HingeStage& stage, const std::vector<double>& inverse_masses, double step,
                  std::vector<Vec3>& velocities);

}  // namespace drape
