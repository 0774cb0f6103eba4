#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/description.h"

namespace drape {

// Reads a scene file. `overrides` are "key.path=value" as YAML ("time.step=1 ms"), checked like the file
// itself. Throws InputError with every problem at once: exit status 2, or 3 where a file can't be read.
SceneDescription load_scene(const std::filesystem::path& path,
                            const std::vector<std::string>& overrides = {});

// What the simulation needs of a scene, ready for Simulation's constructor.
SimulationInput simulation_input(const SceneDescription& scene);

// A hash of all that the simulation's result depends on: two scenes that differ only in how they are drawn,
// or in how many frames they have, share it.
std::uint64_t simulation_fingerprint(const SceneDescription& scene);

}  // namespace drape
