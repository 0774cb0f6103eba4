#pragma once

#include <filesystem>
#include <optional>

#include "scene/node.h"
#include "scene/problem_list.h"

namespace drape {

// Reads a scene's text and the files that its key `include` names, merged deeply: of two maps the union, of
// any other two values the including file's; of two included files the later one's. At most 8 deep and 64
// files, all under the scene's folder. Nothing where the scene itself cannot be read.
std::optional<Node> read_tree(const std::filesystem::path& scene_path, ProblemList& problems);

}  // namespace drape
