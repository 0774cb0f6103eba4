#pragma once

#include <vector>

#include "core/vector.h"
#include "simulation/world.h"

namespace drape {

// Gravity and wind, in m/s2, taken as constant over a step. Pinned points have none.
void external_accelerations(const World& world, const std::vector<Vec3>& positions,
                            const std::vector<Vec3>& velocities, std::vector<Vec3>& accelerations);

}  // namespace drape
