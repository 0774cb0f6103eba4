#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "mesh/polygon_soup.h"
#include "scene/section.h"

namespace drape {

// A key's text; empty, and a problem, where it is none.
std::string text_of(const Section& section, std::string_view key);

// Calls read(path) with the file of that name under the scene's folder. False, and a problem, where there is
// none or `read` throws FileError (a problem at the key) or InputError (where it says, with the key's name
// and place).
bool read_file_of(const Section& section, std::string_view key, const std::string& name,
                  const std::filesystem::path& scene_folder,
                  const std::function<void(const std::filesystem::path&)>& read);

// The polygons of a file that a key names, under the scene's folder. Nothing, and a problem at the key, where
// they cannot be had.
std::optional<PolygonSoup> read_polygons_of(const Section& section, std::string_view key,
                                            const std::string& name,
                                            const std::filesystem::path& scene_folder);

// Whether a mesh is one to simulate with; problems at the key where it is not.
bool is_fit(const Section& section, std::string_view key, const TriangleMesh& mesh);

// The key `mesh` of a section: read, and checked to be fit for simulation.
std::optional<TriangleMesh> read_mesh_key(const Section& section, const std::filesystem::path& scene_folder);

// The keys `mesh` and `rest`: one surface in the shape it starts in and the one it has at rest.
std::optional<ShapedMesh> read_mesh_and_rest(const Section& section,
                                             const std::filesystem::path& scene_folder);

}  // namespace drape
