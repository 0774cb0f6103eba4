#include "scene/scene_text.h"

#include "core/error.h"

namespace drape {
namespace fs = std::filesystem;

const std::string smallest_scene = "version: 1\ncloths: {a: {grid: {size: [1, 1], points: [3, 3]}}}\n";

SceneDescription load_text(const std::string& text, const std::vector<std::string>& overrides) {
  const TemporaryFolder folder;
  return load_scene(folder.write("scene.yaml", text), overrides);
}

Failure failure_of(const fs::path& scene, const fs::path& folder, const std::vector<std::string>& overrides) {
  const std::string prefix = folder.string() + "/";
  try {
    load_scene(scene, overrides);
    return {};
  } catch (const InputError& error) {
    std::string words = error.what();
    for (std::size_t at; (at = words.find(prefix)) != std::string::npos;) words.erase(at, prefix.size());
    return {error.exit_status(), words};
  }
}

std::string errors_of(const std::string& text, const std::vector<std::string>& overrides) {
  const TemporaryFolder folder;
  return failure_of(folder.write("scene.yaml", text), folder.path(), overrides).words;
}

}  // namespace drape
