#include "app/capsule.h"

#include <fmt/format.h>

#include "app/fault_picture.h"
#include "app/triangle_names.h"
#include "core/error.h"
#include "core/file.h"
#include "mesh/mesh_file.h"
#include "render/png_file.h"

namespace drape::app {
namespace fs = std::filesystem;

static ClothSurface surface_of(const SceneDescription& scene, const State& state) {
  ClothSurface surface{state.positions, {}};
  std::size_t first = 0;
  for (const ClothDescription& cloth : scene.cloths) {
    const int offset = static_cast<int>(first);
    for (const auto& [a, b, c] : cloth.input.mesh.triangles)
      surface.triangles.push_back({a + offset, b + offset, c + offset});
    first += cloth.input.mesh.positions.size();
  }
  return surface;
}

static std::string lost_points(const State& state) {
  std::string text;
  for (std::size_t v = 0; v < state.positions.size(); ++v)
    if (!state.positions[v].allFinite()) text += fmt::format("point {} is not finite\n", v + 1);
  return text;
}

// One line for each point, pair and triangle at fault.
static std::string faults_in_words(const SceneDescription& scene, const FailedFrame& failed) {
  std::string text = lost_points(failed.after);
  for (const auto& [s, t] : failed.certified.intersecting)
    text += fmt::format("{} meets {}\n", name_in_cloth(scene, s), name_in_cloth(scene, t));
  for (const int t : failed.certified.in_colliders)
    text += fmt::format("{} is in a collider\n", name_in_cloth(scene, t));
  return text;
}

static void write_shape(const fs::path& path, const ClothSurface& surface) {
  write_obj(path, {surface.positions, surface.triangles, {}, {}});
}

static std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

void stop_with_capsule(const Run& run, const FailedFrame& failed) {
  const fs::path folder = run.folder.root / "failure";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string command = "drape simulate " + run.folder.root.string();
  const ClothSurface before = surface_of(run.scene, failed.before),
                     after = surface_of(run.scene, failed.after);
  const std::string faults = faults_in_words(run.scene, failed);
  write_checkpoint(folder, run.manifest.fingerprint, failed.before);
  write_shape(folder / "before.obj", before);
  write_shape(folder / "after.obj", after);
  write_file(folder / "faults.txt", faults);
  write_file(folder / "command.txt", command + "\n");
  const std::vector<int> faces = faulty_triangles(after, failed.certified);
  if (!faces.empty()) render::write_png(folder / "faces.png", draw_faults(after, faces));
  throw SimulationError(fmt::format(
      "frame {}: {}: {}; {} holds the state before, both shapes, all faults{}; '{}' makes the frame again",
      failed.before.frame + 1, failed.reason, first_line(faults), folder.string(),
      faces.empty() ? "" : " and a picture of them", command));
}

}  // namespace drape::app
