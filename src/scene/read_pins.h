#pragma once

#include <string_view>
#include <vector>

#include "scene/section.h"
#include "simulation/input.h"

namespace drape {

// The list `pins` of a cloth whose mesh and start are known; `colliders` are the names of those that pins can
// follow. A pin that holds no vertex is a problem, and so is a vertex that two pins hold at the same time.
std::vector<PinInput> read_pins(const Section& cloth, const ClothInput& input,
                                const std::vector<std::string_view>& colliders, double fps);

}  // namespace drape
