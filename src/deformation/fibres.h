#pragma once

#include <cstddef>
#include <vector>

#include "deformation/coloring.h"
#include "deformation/sheet.h"

namespace drape {

// Inextensible fibres (section 4.2 of the paper): chains of edges, as straight as the mesh allows, whose
// lengths are restored all at once. Fibre f runs over vertices[vertex_begin[f] .. vertex_begin[f + 1]); its
// edges are one fewer, and begin at vertex_begin[f] - f in rest_lengths and compliances.
struct FibreStage {
  std::vector<int> vertices;
  std::vector<std::size_t> vertex_begin{0};
  std::vector<double> rest_lengths;  // m
  std::vector<double> compliances;   // 1 / (stiffness h2) in 1/kg: 0 would be quite inextensible
  std::vector<std::size_t> color_begin;
};

// Pairs the edges at each vertex, the straightest pair first (ties by edge number), and accepts pairs of at
// least 135 degrees; a chain ends where no pair goes on, and is cut where it would meet itself. Every edge is
// in exactly one fibre.
std::vector<std::vector<int>> trace_fibres(const Sheet& sheet);  // vertices of each fibre

FibreStage build_fibres(const Sheet& sheet, double step);

// Scratch of a sweep: one slot an edge.
struct FibreScratch {
  std::vector<Vec3> directions;
  std::vector<double> diagonal, tension;
};

// The two sweeps of section 4.2 inject energy; instead, one Newton step for all lengths of a fibre together,
// which is a tridiagonal system and keeps both momenta:
//   (w_i + w_(i+1) + c_i) t_i - w_i (d_(i-1) . d_i) t_(i-1) - w_(i+1) (d_i . d_(i+1)) t_(i+1) = |e_i| - l_i
//   x_i += w_i (t_i d_i - t_(i-1) d_(i-1))
// with w the inverse masses, d the unit edges, t the tensions times h2 and c the compliances (Goldenthal et
// al. 2007, fast projection, on one fibre). Gauss-Seidel over the fibres.
void pull_fibres(const FibreStage& stage, const std::vector<double>& inverse_masses, FibreScratch& scratch,
                 std::vector<Vec3>& x);

}  // namespace drape
