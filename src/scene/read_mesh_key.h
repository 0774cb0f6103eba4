#pragma once

#include <filesystem>
#include <optional>

#include "mesh/triangle_mesh.h"
#include "scene/section.h"

namespace drape {

// The key `mesh` of a section: read, and checked to be fit for simulation.
std::optional<TriangleMesh> read_mesh_key(const Section& section, const std::filesystem::path& scene_folder);

}  // namespace drape
