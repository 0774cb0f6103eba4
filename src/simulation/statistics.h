#pragma once

#include "simulation/simulation.h"
#include "simulation/world.h"

namespace drape {

// What a state shows; limited_vertices and profile are the caller's.
FrameStatistics measure(const World& world, const State& state);

}  // namespace drape
