#pragma once

#include <vector>

#include "scene/section.h"
#include "simulation/input.h"

namespace drape {

// The list `pins` of a cloth whose mesh and start are known. A pin that holds no vertex is a problem, and so
// is a vertex that two pins hold.
std::vector<PinInput> read_pins(const Section& cloth, const ClothInput& input, double fps);

}  // namespace drape
