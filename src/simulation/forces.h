#pragma once

#include <vector>

#include "core/vector.h"
#include "simulation/world.h"

namespace drape {

// The force of the air on each triangle (N), to be held for world.steps_per_air steps from `time` (s) on,
// where these are the positions (m) and velocities (m/s). It never adds relative motion: velocities +=
// duration * accelerations leaves sum m |v - w|2 no greater than it was, w a wind that blows alike
// everywhere. Empty forces stay empty where there is no air.
void feel_air(const World& world, double time, const std::vector<Vec3>& positions,
              const std::vector<Vec3>& velocities, std::vector<Vec3>& air_forces);

// The accelerations (m/s2, one for each point) by gravity, air and pressure, to be held for one step that
// starts with these positions (m). Zero for pinned points.
void external_accelerations(const World& world, const std::vector<Vec3>& air_forces,
                            const std::vector<Vec3>& positions, std::vector<Vec3>& accelerations);

}  // namespace drape
