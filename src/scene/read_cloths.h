#pragma once

#include <filesystem>
#include <vector>

#include "scene/description.h"
#include "scene/section.h"

namespace drape {

// The cloths of a scene. One with a mistake in its shape is left out, after its other keys have been checked.
std::vector<ClothDescription> read_cloths(const Section& scene, const std::filesystem::path& scene_folder,
                                          double fps);

}  // namespace drape
