#include "scene/read_mesh_key.h"

#include <fmt/format.h>

#include "core/error.h"
#include "mesh/manifold.h"
#include "mesh/mesh_file.h"
#include "scene/scene_file.h"
#include "scene/section_values.h"

namespace drape {
namespace fs = std::filesystem;

static std::optional<TriangleMesh> read_or_report(const fs::path& path, const Section& section) {
  const Place place = find_value(section, "mesh")->place;
  try {
    return read_mesh(path);
  } catch (const FileError& error) {
    section.problems->add_file_fault(place, fmt::format("{}: {}", path_of(section, "mesh"), error.what()));
  } catch (const InputError& error) {
    for (const Problem& problem : error.problems())
      section.problems->add_file_fault(
          {std::make_shared<const std::string>(problem.file), problem.line, problem.column}, problem.message);
  }
  return std::nullopt;
}

std::optional<TriangleMesh> read_mesh_key(const Section& section, const fs::path& scene_folder) {
  std::string name;
  read_text(section, "mesh", name);
  if (name.empty()) return std::nullopt;
  const Place place = find_value(section, "mesh")->place;
  const auto path =
      find_scene_file(name, path_of(section, "mesh"), scene_folder, scene_folder, place, *section.problems);
  if (!path) return std::nullopt;
  auto mesh = read_or_report(*path, section);
  if (!mesh) return std::nullopt;
  const std::vector<std::string> faults = check_manifold(*mesh);
  for (const std::string& fault : faults)
    section.problems->add_file_fault(place, fmt::format("{}: {}: {}", path_of(section, "mesh"), name, fault));
  if (!faults.empty()) return std::nullopt;
  return mesh;
}

}  // namespace drape
