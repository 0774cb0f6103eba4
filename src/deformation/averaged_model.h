#pragma once

#include <cstddef>
#include <vector>

#include "core/incidence.h"
#include "deformation/sheet.h"
#include "deformation/triangle_match.h"

namespace drape {

// The paper's own form of section 4: triangle clusters of outer corners (4.1), inextensible fibres by two
// sweeps (4.2), every goal found at x*, and one averaged pass, x** = x* + alpha (sum of a point's goal
// displacements) / M_i, with M_i the number of clusters, fibres included, that the point belongs to. The
// stiffness is the share alpha in each step: it has no units, and depends on the step and on the mesh.
//
// A slot is one point of one cluster: three for each triangle cluster, then one for each point of each fibre.
struct AveragedModel {
  std::vector<int> vertices;                 // of each slot
  std::vector<MatchConstants<double>> rest;  // of each triangle cluster
  std::vector<std::size_t> fibre_begin;      // fibre f: slots [fibre_begin[f], fibre_begin[f + 1])
  std::vector<double> rest_lengths;          // m; of each slot of a fibre to its next, 0 at the last
  std::vector<double> weights;               // kg; of each point in each of its clusters
  std::vector<char> pinned;                  // of each point
  Incidence incidence;                       // M_i is how many slots a point has
  double alpha;                              // blending parameter of MHTG05
};

// Scratch of a pass: one goal displacement a slot.
struct AveragedScratch {
  std::vector<Vec3> displacements;
};

// `masses` in kg, positive; `alpha` in (0, 1]. A point weighs m_i / M_i in its clusters (RJ07, section 4:
// "modified mass"), since m_i would keep momentum in each cluster but not in their average. Pinned points
// weigh 1e4 times as much, so that clusters turn about them; the paper does not treat them.
AveragedModel build_averaged_model(const Sheet& sheet, const std::vector<double>& masses,
                                   const std::vector<char>& pinned, double alpha);

// x* -> x**. Keeps linear momentum, as long as nothing is pinned, but not angular momentum, and may add
// energy: tests/deformation/test_averaged_model.cpp measures both. Pinned points stay. With MHTG05's
// integration the step's velocity is (x** - x) / h.
void pull_averaged(const AveragedModel& model, AveragedScratch& scratch, std::vector<Vec3>& x);

}  // namespace drape
