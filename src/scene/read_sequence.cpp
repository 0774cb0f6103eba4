#include "scene/read_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "mesh/mesh_file.h"
#include "scene/read_mesh_key.h"
#include "scene/section_values.h"

namespace drape {
namespace fs = std::filesystem;

static constexpr std::size_t most_files = 100'000, most_points = 50'000'000;

bool names_sequence(const std::string& name) { return name.find('#') != std::string::npos; }

namespace {

// "body." and ".obj" about a number of some digits.
struct Pattern {
  std::string before, after;
  std::size_t digits;
};

}  // namespace

static Pattern pattern_of(const std::string& file_name) {
  const std::size_t begin = file_name.find('#'), end = file_name.find_last_of('#') + 1;
  return {file_name.substr(0, begin), file_name.substr(end), end - begin};
}

// The number in a name that fits the pattern, with as many digits or more.
static std::optional<int> number_in(const Pattern& pattern, const std::string& name) {
  const std::size_t fixed = pattern.before.size() + pattern.after.size();
  if (name.size() < fixed + pattern.digits || name.size() > fixed + 9) return std::nullopt;
  if (!name.starts_with(pattern.before) || !name.ends_with(pattern.after)) return std::nullopt;
  const std::string digits = name.substr(pattern.before.size(), name.size() - fixed);
  const bool is_number =
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  return is_number ? std::optional(std::stoi(digits)) : std::nullopt;
}

// By number, the names as in the scene.
static std::map<int, std::string> files_of(const fs::path& name, const fs::path& scene_folder) {
  const Pattern pattern = pattern_of(name.filename().string());
  const fs::path folder = scene_folder / name.parent_path();
  std::map<int, std::string> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error))
    if (const auto number = number_in(pattern, entry.path().filename().string()))
      files[*number] = (name.parent_path() / entry.path().filename()).string();
  return files;
}

static bool check_numbers(const Section& section, const std::string& name,
                          const std::map<int, std::string>& files) {
  const auto complain = [&](const std::string& what) {
    section.problems->add_file_fault(find_value(section, "mesh")->place,
                                     fmt::format("{}: {}: {}", path_of(section, "mesh"), name, what));
    return false;
  };
  if (files.size() < 2) return complain("needs two files at least that fit this pattern (# is a digit)");
  if (files.size() > most_files) return complain(fmt::format("more than {} files", most_files));
  int next = files.begin()->first;
  for (const auto& [number, file] : files)
    if (number != next++) return complain(fmt::format("number {} is missing before {}", next - 1, file));
  return true;
}

// All of them in the shapes' order, or nothing and a problem.
static std::optional<SoupInShapes> read_all(const Section& section, const fs::path& scene_folder,
                                            const std::map<int, std::string>& files) {
  std::optional<SoupInShapes> result;
  for (const auto& [number, file] : files) {
    auto soup = read_polygons_of(section, "mesh", file, scene_folder);
    if (!soup) return std::nullopt;
    const auto complain = [&](const std::string& what) {
      section.problems->add_file_fault(find_value(section, "mesh")->place,
                                       fmt::format("{}: {}", path_of(section, "mesh"), what));
      return std::nullopt;
    };
    if (result && !have_same_faces(result->soup, *soup))
      return complain(
          fmt::format("{} has {}, and {} has {}: all shapes need the same faces in the same order", file,
                      size_text(*soup), files.begin()->second, size_text(result->soup)));
    if (files.size() * soup->points.size() > most_points)
      return complain(fmt::format("{} files of {} points are more than {} points", files.size(),
                                  soup->points.size(), most_points));
    if (!result) result = SoupInShapes{*soup, {}};
    result->shapes.push_back(std::move(soup->points));
  }
  return result;
}

// The surface in its shapes, or nothing and a problem.
static std::optional<MeshShape> make_shape(const Section& section, const SoupInShapes& soup,
                                           double first_time, double interval) {
  MeshInShapes welded = weld(soup);
  if (!is_fit(section, "mesh", welded.mesh)) return std::nullopt;
  return MeshShape{std::move(welded.mesh), std::move(welded.shapes), first_time, interval};
}

std::optional<MeshShape> read_sequence(const Section& section, const fs::path& scene_folder, double fps) {
  const std::string name = text_of(section, "mesh");
  const std::map<int, std::string> files = files_of(name, scene_folder);
  if (!check_numbers(section, name, files)) return std::nullopt;
  const auto soup = read_all(section, scene_folder, files);
  if (!soup) return std::nullopt;
  return make_shape(section, *soup, files.begin()->first / fps, 1 / fps);
}

// The shapes of the clip that the key `clip` names, or nothing and a problem there.
static std::optional<SoupInShapes> read_clip_of(const Section& section, const fs::path& path,
                                                const ClipRequest& clip) {
  try {
    return read_clip(path, clip);
  } catch (const UnknownClip& error) {
    section.problems->add(
        find_value(section, "clip")->place,
        fmt::format("{}: {} {}", path_of(section, "clip"), text_of(section, "mesh"), error.what()));
    return std::nullopt;
  }
}

std::optional<MeshShape> read_clip_key(const Section& section, const fs::path& scene_folder, double fps) {
  const ClipRequest clip{text_of(section, "clip"), 1 / fps};
  std::optional<SoupInShapes> soup;
  read_file_of(section, "mesh", text_of(section, "mesh"), scene_folder,
               [&](const fs::path& path) { soup = read_clip_of(section, path, clip); });
  return soup ? make_shape(section, *soup, 0, 1 / fps) : std::nullopt;
}

}  // namespace drape
