#pragma once

#include "contact/edge_limits.h"
#include "deformation/sheet.h"

namespace drape {

// Cloth stiffens as its yarns straighten: edges get longer by 2 % and shorter by 5 %, or by what a tension of
// 400 N/m does along the edge where that is more (as of 40 kg that hang on a strip of a metre), and hardly
// more. Where the material has a strain limit, that is how much longer, and shorter where it is more than 5
// %. Between materials the tighter limits hold.
EdgeLimits build_strain_limits(const Sheet& sheet);

}  // namespace drape
