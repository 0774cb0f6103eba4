#pragma once

#include <optional>

#include "contact/closest_points.h"

namespace drape {

// The first time in [0, 1] at which the two sides, moving straight from `start` to `end`, are no farther
// apart than `distance`; nothing where they never are. Additive conservative advancement (Li et al. 2021,
// Codimensional Incremental Potential Contact, 3.4). It errs only to the safe side: a time that is too early
// by what it takes to close `tolerance`, or a grazing pass within `tolerance` reported as a hit.
std::optional<double> time_of_contact(PairKind kind, const FourPoints& start, const FourPoints& end,
                                      double distance, double tolerance);

// An upper bound of how much the distance can change on the way: the largest motions of both sides added,
// without what they have in common.
double relative_motion(PairKind kind, const FourPoints& start, const FourPoints& end);

}  // namespace drape
