#pragma once

#include "simulation/simulation.h"
#include "simulation/world.h"

namespace drape {

// Stretch, energy and speed of a state; contacts, lag and profile are the caller's.
FrameStatistics measure(const World& world, const State& state);

}  // namespace drape
