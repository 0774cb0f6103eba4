#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/problem_list.h"

namespace drape {

// The path that a scene names, if it stays under the scene's folder (also through links) and is a regular
// file; otherwise nothing and a problem at `place`.
std::optional<std::filesystem::path> find_scene_file(const std::string& name, const std::string& key_path,
                                                     const std::filesystem::path& relative_to,
                                                     const std::filesystem::path& scene_folder,
                                                     const Place& place, ProblemList& problems);

}  // namespace drape
