#pragma once

#include "contact/edge_limits.h"
#include "deformation/sheet.h"

namespace drape {

// What contact may make of a sheet's edges: by 2 % longer and 5 % shorter than at rest, or by what a tension
// of 400 N/m does along the edge where that is more (as of 40 kg that hang on a strip of a metre). Where the
// material has a strain limit, no longer than that.
EdgeLimits build_strain_limits(const Sheet& sheet);

}  // namespace drape
