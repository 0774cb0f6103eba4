#pragma once

#include <cstddef>
#include <vector>

#include "core/lanes.h"
#include "deformation/sheet.h"
#include "deformation/split_points.h"

namespace drape {

// Inextensible fibres (section 4.2 of the paper): chains of edges, as straight as the mesh allows, whose
// lengths are restored all at once. They lie in groups of eight (one a lane) that share no vertex; colours of
// groups likewise.
struct FibreStage {
  std::vector<IndexRow>
      vertices;  // of group g: [row_begin[g] .. row_begin[g + 1]); shorter ones repeat their last
  std::vector<std::size_t> row_begin{0};
  std::vector<LaneRow> rest_lengths;     // m; of the edge that ends at the row's vertices
  std::vector<LaneRow> compliances;      // 1 / (stiffness h2) in 1/kg; 0 would be quite inextensible
  std::vector<LaneRow> longest;          // m: what the strain limit allows
  std::vector<std::size_t> color_begin;  // groups of colour c: [color_begin[c] .. color_begin[c + 1])
  std::size_t longest_group = 0;         // rows
};

// Pairs the edges at each vertex, the straightest pair first (ties by edge number), and accepts pairs of at
// least 135 degrees; a chain ends where no pair goes on, and is cut where it would meet itself. Every edge is
// in exactly one fibre.
std::vector<std::vector<int>> trace_fibres(const Sheet& sheet);  // vertices of each fibre

// `stiffnesses` in N/m as a bar, of each edge of the topology. Where the sheet's material has a strain limit,
// an edge that is longer counts as inextensible beyond it.
FibreStage build_fibres(const Sheet& sheet, const std::vector<double>& stiffnesses, double step);

// The edges where a step starts, three rows each; and what a sweep works in.
struct FibreScratch {
  std::vector<LaneRow> base;
  std::vector<LaneRow> work;  // of a few groups at a time: see FibreStage::longest_group
};
void load_fibres(const FibreStage& stage, const SplitPoints& start, FibreScratch& scratch);

// The two sweeps of section 4.2 inject energy; instead, one Newton step for all lengths of a fibre together,
// which is a tridiagonal system and keeps both momenta:
//   (w_i + w_(i+1) + c_i) t_i - w_i (d_(i-1) . d_i) t_(i-1) - w_(i+1) (d_i . d_(i+1)) t_(i+1) = |e_i| - l_i
//   x_i += w_i (t_i d_i - t_(i-1) d_(i-1))
// with w the inverse masses, d the unit edges, t the tensions times h2 and c the compliances (Goldenthal et
// al. 2007, fast projection, on one fibre). Gauss-Seidel over the fibres; offsets as in pull_membrane.
void pull_fibres(const FibreStage& stage, FibreScratch& scratch, std::vector<Point4>& offsets);

}  // namespace drape
