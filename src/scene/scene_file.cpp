#include "scene/scene_file.h"

#include <fmt/format.h>

namespace drape {
namespace fs = std::filesystem;

static bool is_under(const fs::path& path, const fs::path& folder) {
  const fs::path relative = path.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

std::optional<fs::path> find_scene_file(const std::string& name, const std::string& key_path,
                                        const fs::path& relative_to, const fs::path& scene_folder,
                                        const Place& place, ProblemList& problems) {
  std::error_code error;
  const fs::path path = relative_to / name;
  const fs::path folder = fs::weakly_canonical(scene_folder.empty() ? "." : scene_folder, error);
  // Of a relative path of which nothing exists, weakly_canonical makes no absolute one.
  const fs::path resolved = fs::weakly_canonical(fs::absolute(path, error), error);
  if (error || fs::path(name).is_absolute() || !is_under(resolved, folder)) {
    problems.add(place,
                 fmt::format("{} must be a file under the scene's folder, not {}", key_path, quote(name)));
    return std::nullopt;
  }
  if (!fs::exists(resolved, error)) {
    problems.add_file_fault(place,
                            fmt::format("{}: no file `{}`", key_path, path.lexically_normal().string()));
    return std::nullopt;
  }
  if (!fs::is_regular_file(resolved, error)) {
    problems.add_file_fault(place, fmt::format("{}: {} is not a regular file", key_path, quote(name)));
    return std::nullopt;
  }
  return path;
}

}  // namespace drape
