#pragma once

#include "contact/edge_limits.h"
#include "deformation/sheet.h"

namespace drape {

// Cloth stiffens as its yarns straighten: edges get hardly longer than by 2 % or shorter than by 5 %, or by
// what a tension of 400 N/m does along the edge where that is more (as of 40 kg that hang on a strip of a
// metre). Where the material has a strain limit, that is how much longer, and shorter if it is over 5 %.
// Between materials the tighter limits hold.
EdgeLimits build_strain_limits(const Sheet& sheet);

}  // namespace drape
