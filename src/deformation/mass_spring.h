#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/incidence.h"
#include "deformation/sheet.h"

namespace drape {

// The model that section 6.1 of the paper compares with: Bridson, Marino and Fedkiw 2003 (BMF03), Simulation
// of clothing with folds and wrinkles. Springs on edges resist stretch and shear, and one bending element on
// each pair of neighbour triangles resists bending, with forces that have no part in any in-plane motion.
//
// Every element has one measure, a length or an angle, and acts on its points by
//   F_i = -(elastic + damping * rate) g_i,   g_i the measure's gradient at x_i,   rate = sum g_i . v_i,
// which keeps both momenta, since a length and an angle do not change in rigid motion.
struct Spring {
  std::array<int, 2> vertices;
  double rest_length;  // m
  double stiffness;    // N/m
  double damping;      // N s/m
};

// Its points are x1 and x2 across the edge, then the edge's x3 and x4, in BMF03's order.
struct BendingElement {
  std::array<int, 4> vertices;
  std::array<double, 4> gradient_lengths;  // |u_i| of the rest shape, 1/m
  double rest_sine;                        // sin(theta0 / 2); 0 where the rest shape is flat
  double stiffness;                        // N m: k_e |E|2 / (|N1| + |N2|) of the rest shape
  double damping;                          // N m s
};

// Slots are the elements' points put end to end: two for each spring, then four for each bending element.
struct MassSpringModel {
  std::vector<Spring> springs;
  std::vector<BendingElement> bending;
  std::vector<double> inverse_masses;  // 1/kg; 0 where pinned
  Incidence incidence;
  double stable_step;  // s: the largest that advance_mass_spring takes
};

// Scratch of a step: a gradient a slot, an elastic force (N or N m) and a whole one an element.
struct MassSpringScratch {
  std::vector<Vec3> gradients;
  std::vector<double> elastic, force;
  std::vector<Vec3> middle_velocities;
};

// `masses` in kg, positive. A spring's stiffness is that of a membrane without contraction across, Y A / l2
// summed over its triangles (Van Gelder 1998, Approximate simulation of elastic membranes by triangulated
// spring meshes): exact along the edges of a regular grid and in every direction of an equilateral mesh.
// Bending has the flexural rigidity of the material on an equilateral mesh, and along the edges of a regular
// grid. An element's damping is the material's, but no more than a twentieth of its critical damping.
MassSpringModel build_mass_spring(const Sheet& sheet, const std::vector<double>& masses,
                                  const std::vector<char>& pinned);

// A bound, in seconds, on the steps that are stable. As to springs it holds in every shape, tension and
// turning included; as to bending it allows twice the stiffness of the flat rest shape, for folds and for
// squeezed triangles, whose elements a step weakens where they would exceed that. Infinite where every point
// is pinned. Measured: a hanging sheet is stable up to 1.4 times the bound without damping, more with it.
double largest_stable_step(const MassSpringModel& model);

// One step of the explicit leapfrog of second order, in its drift-kick-drift order:
//   x_half = x + h/2 v,   v' = v + h a(x_half, (v + v') / 2),   x' = x_half + h/2 v',
// with the mean velocity, on which only damping depends, from an explicit half step. It has BMF03's order,
// symmetry and bound on the step, and needs one evaluation of elastic forces; BMF03's own order,
// kick-drift-kick, needs two or a state to keep the last. `accelerations` (m/s2) are those of outer forces,
// one a point, for the whole step. Keeps momentum and angular momentum to rounding. Pinned points stay where
// the caller put them (for second order: where they are at the middle of the step); their velocities are
// read, for damping, and not changed. The bits do not depend on the number of threads. Throws SimulationError
// where `step` (s) is larger than model.stable_step.
void advance_mass_spring(const MassSpringModel& model, const std::vector<Vec3>& accelerations, double step,
                         MassSpringScratch& scratch, std::vector<Vec3>& positions,
                         std::vector<Vec3>& velocities);

}  // namespace drape
