#include "scene/read_mesh_key.h"

#include <fmt/format.h>

#include "core/error.h"
#include "mesh/manifold.h"
#include "mesh/mesh_file.h"
#include "scene/scene_file.h"
#include "scene/section_values.h"

namespace drape {
namespace fs = std::filesystem;

std::string text_of(const Section& section, std::string_view key) {
  std::string text;
  read_text(section, key, text);
  return text;
}

// "scene.yaml:4:11", or the override of the command line.
static std::string in_words(const Place& place) {
  return place.line == 0 ? *place.file : fmt::format("{}:{}:{}", *place.file, place.line, place.column);
}

// Where what is wrong stands, and who wants the file.
static void add_fault_of_file(const Section& section, std::string_view key, const Place& asked_at,
                              const Problem& fault) {
  section.problems->add_file_fault(
      {std::make_shared<const std::string>(fault.file), fault.line, fault.column},
      fmt::format("{} ({} at {} names this file)", fault.message, path_of(section, key), in_words(asked_at)));
}

bool read_file_of(const Section& section, std::string_view key, const std::string& name,
                  const fs::path& scene_folder, const std::function<void(const fs::path&)>& read) {
  const Place place = find_value(section, key)->place;
  const auto path =
      find_scene_file(name, path_of(section, key), scene_folder, scene_folder, place, *section.problems);
  if (!path) return false;
  try {
    read(*path);
    return true;
  } catch (const FileError& error) {
    section.problems->add_file_fault(place, fmt::format("{}: {}", path_of(section, key), error.what()));
  } catch (const InputError& error) {
    for (const Problem& fault : error.problems()) add_fault_of_file(section, key, place, fault);
  }
  return false;
}

std::optional<PolygonSoup> read_polygons_of(const Section& section, std::string_view key,
                                            const std::string& name, const fs::path& scene_folder) {
  std::optional<PolygonSoup> soup;
  read_file_of(section, key, name, scene_folder, [&](const fs::path& path) { soup = read_polygons(path); });
  return soup;
}

static std::optional<PolygonSoup> read_polygons_key(const Section& section, std::string_view key,
                                                    const fs::path& scene_folder) {
  const std::string name = text_of(section, key);
  return name.empty() ? std::nullopt : read_polygons_of(section, key, name, scene_folder);
}

bool is_fit(const Section& section, std::string_view key, const TriangleMesh& mesh) {
  const std::vector<std::string> faults = check_manifold(mesh);
  for (const std::string& fault : faults)
    section.problems->add_file_fault(
        find_value(section, key)->place,
        fmt::format("{}: {}: {}", path_of(section, key), text_of(section, key), fault));
  return faults.empty();
}

std::optional<TriangleMesh> read_mesh_key(const Section& section, const fs::path& scene_folder) {
  const auto soup = read_polygons_key(section, "mesh", scene_folder);
  if (!soup) return std::nullopt;
  TriangleMesh mesh = weld(*soup);
  if (!is_fit(section, "mesh", mesh)) return std::nullopt;
  return mesh;
}

static bool check_same_faces(const Section& section, const PolygonSoup& rest, const PolygonSoup& start) {
  if (have_same_faces(rest, start)) return true;
  section.problems->add_file_fault(
      find_value(section, "rest")->place,
      fmt::format("{}: {} has {}, and {} has {}: the shape at rest needs the same faces in the same order",
                  path_of(section, "rest"), text_of(section, "rest"), size_text(rest),
                  text_of(section, "mesh"), size_text(start)));
  return false;
}

std::optional<ShapedMesh> read_mesh_and_rest(const Section& section, const fs::path& scene_folder) {
  const auto start = read_polygons_key(section, "mesh", scene_folder),
             rest = read_polygons_key(section, "rest", scene_folder);
  if (!start || !rest || !check_same_faces(section, *rest, *start)) return std::nullopt;
  ShapedMesh shaped = weld(*rest, *start);
  if (!is_fit(section, "rest", shaped.mesh)) return std::nullopt;
  return shaped;
}

}  // namespace drape
