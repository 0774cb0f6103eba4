#pragma once

#include <vector>

#include "core/vector.h"
#include "simulation/world.h"

namespace drape {

// The accelerations (m/s2, one for each point) by gravity, air and pressure, to be held for one step that
// starts with these positions (m) and velocities (m/s) at `time` (s). Zero for pinned points. The air's share
// never adds relative motion: a step of velocities += world.step * accelerations leaves sum m |v - w|2 no
// greater than it was, w a wind that blows alike everywhere.
void external_accelerations(const World& world, double time, const std::vector<Vec3>& positions,
                            const std::vector<Vec3>& velocities, std::vector<Vec3>& accelerations);

}  // namespace drape
