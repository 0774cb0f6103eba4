#pragma once

#include <vector>

#include "core/vector.h"
#include "simulation/world.h"

namespace drape {

// Gravity and wind over one step, into the velocities. Pinned points are left alone.
void apply_external_forces(const World& world, const std::vector<Vec3>& positions,
                           std::vector<Vec3>& velocities);

}  // namespace drape
