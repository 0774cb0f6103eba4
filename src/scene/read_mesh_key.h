#pragma once

#include <filesystem>
#include <optional>

#include "mesh/polygon_soup.h"
#include "scene/section.h"

namespace drape {

// The key `mesh` of a section: read, and checked to be fit for simulation.
std::optional<TriangleMesh> read_mesh_key(const Section& section, const std::filesystem::path& scene_folder);

// The keys `mesh` and `rest`: one surface in the shape it starts in and the one it has at rest.
std::optional<ShapedMesh> read_mesh_and_rest(const Section& section,
                                             const std::filesystem::path& scene_folder);

}  // namespace drape
