#include <fmt/format.h>

#include <cmath>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/progress.h"
#include "app/run.h"
#include "app/view.h"
#include "mesh/topology.h"

namespace drape::app {

// Rough costs on one core of a common machine, for estimates before anything has run.
static constexpr double cpu_seconds_per_point_step = 4e-6;
static constexpr double cpu_seconds_per_pixel_pass = 2e-7;
static constexpr double bytes_per_point = 2500;  // state, clusters, and the grid of contact
static constexpr double bytes_per_pixel = 40;    // the buffers of one context
static constexpr double bytes_at_start = 80e6;

namespace {
struct SceneSize {
  std::size_t points = 0;
  int steps_per_frame = 0;
  int frames = 0;
};
}  // namespace

static SceneSize measure(const SceneDescription& scene) {
  SceneSize size;
  for (const ClothDescription& cloth : scene.cloths) size.points += cloth.input.mesh.positions.size();
  size.steps_per_frame = static_cast<int>(std::ceil(1 / (scene.time.fps * scene.time.step) - 1e-9));
  size.frames = scene.time.last_frame - scene.time.first_frame + 1;
  return size;
}

static void print_cloths(const SceneDescription& scene) {
  for (const ClothDescription& cloth : scene.cloths) {
    const TriangleMesh& mesh = cloth.input.mesh;
    const auto edges = build_topology(static_cast<int>(mesh.positions.size()), mesh.triangles).edges.size();
    print_result(fmt::format("cloth      {}: {} points, {} triangles, {} edges", cloth.input.name,
                             mesh.positions.size(), mesh.triangles.size(), edges));
  }
}

static void print_time(const SceneDescription& scene, const SceneSize& size) {
  print_result(fmt::format("frames     {}-{} at {} a second ({:.2f} s)", scene.time.first_frame,
                           scene.time.last_frame, scene.time.fps, size.frames / scene.time.fps));
  print_result(fmt::format("steps      {} a frame, {} in all", size.steps_per_frame,
                           size.steps_per_frame * scene.time.last_frame));
}

// The start of a run knows nothing of its contacts: these figures say hours or minutes, no more.
static void print_estimate(const SceneDescription& scene, const SceneSize& size) {
  const render::Settings picture = picture_settings(scene.render);
  const double pixels = static_cast<double>(picture.width) * picture.height;
  const double simulation = cpu_seconds_per_point_step * static_cast<double>(size.points) *
                            size.steps_per_frame * scene.time.last_frame;
  const double pictures = cpu_seconds_per_pixel_pass * pixels * picture.passes * size.frames;
  const double memory =
      bytes_at_start + bytes_per_point * static_cast<double>(size.points) + bytes_per_pixel * pixels;
  print_result(fmt::format("pictures   {}x{}, {} passes", picture.width, picture.height, picture.passes));
  print_result(fmt::format("time       about {} of CPU to simulate, {} to render",
                           format_duration(simulation), format_duration(pictures)));
  print_result(fmt::format("memory     about {:.0f} MB", memory / 1e6));
}

int info_command(const Options& options, const Console&) {
  const Run run = open_run(options.inputs.front(), options.overrides, options.output);
  const SceneSize size = measure(run.scene);
  print_result(fmt::format("scene      {} ({})", run.scene.name, run.scene.file));
  print_cloths(run.scene);
  print_result(fmt::format("colliders  {}", run.scene.colliders.size()));
  print_time(run.scene, size);
  print_estimate(run.scene, size);
  print_result(fmt::format("output     {}", run.folder.root.string()));
  print_result(fmt::format("simulated  {} frames so far", run.manifest.frames.size()));
  return static_cast<int>(ExitStatus::done);
}

}  // namespace drape::app
