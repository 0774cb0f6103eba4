#include <fmt/format.h>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/progress.h"
#include "app/run.h"
#include "app/start.h"
#include "app/view.h"
#include "mesh/topology.h"
#include "scene/load.h"
#include "simulation/world.h"

namespace drape::app {

// Rough costs on one core of a common machine, for estimates before anything has run.
static constexpr double cpu_seconds_per_point_step = 4e-6;
static constexpr double cpu_seconds_per_pass = 0.055;  // shadows, whatever the size of the picture
static constexpr double cpu_seconds_per_pixel_pass = 1.7e-7;
static constexpr double bytes_to_simulate = 30e6;
static constexpr double bytes_per_point = 20e3;  // state, clusters, and the search for contacts
static constexpr double bytes_per_context = 140e6;
static constexpr double bytes_per_pixel = 35;

namespace {
struct SceneSize {
  std::size_t points = 0;
  int steps_per_frame = 0;
  double longest_model_step = 0;  // seconds
  int frames = 0;
};
}  // namespace

static SceneSize measure(const SceneDescription& scene) {
  SceneSize size;
  for (const ClothDescription& cloth : scene.cloths) size.points += cloth.input.mesh.positions.size();
  const StepChoice steps = choose_steps(simulation_input(scene));
  size.steps_per_frame = steps.per_frame;
  size.longest_model_step = steps.longest_for_model;
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
  if (scene.model != DeformationModel::averaged)
    print_result(fmt::format("model      its longest step is {:.3g} ms", 1000 * size.longest_model_step));
}

static double seconds_to_simulate(const SceneDescription& scene, const SceneSize& size) {
  return cpu_seconds_per_point_step * static_cast<double>(size.points) * size.steps_per_frame *
         scene.time.last_frame;
}

// What a run will meet cannot be known before: these figures tell minutes from hours, no more.
static void print_estimate(const SceneDescription& scene, const SceneSize& size) {
  const render::Settings picture = picture_settings(scene.render);
  const double pixels = static_cast<double>(picture.width) * picture.height;
  const double seconds_a_pass = cpu_seconds_per_pass + cpu_seconds_per_pixel_pass * pixels;
  const double points = static_cast<double>(size.points);
  print_result(fmt::format("pictures   {}x{}, {} passes", picture.width, picture.height, picture.passes));
  print_result(fmt::format("CPU time   about {} to simulate, {} to render",
                           format_duration(seconds_to_simulate(scene, size)),
                           format_duration(seconds_a_pass * picture.passes * size.frames)));
  print_result(fmt::format("memory     about {:.0f} MB to simulate, {:.0f} MB for each picture at a time",
                           1e-6 * (bytes_to_simulate + bytes_per_point * points),
                           1e-6 * (bytes_per_context + bytes_per_pixel * pixels)));
}

// Judged as `simulate` judges it before it begins: of a large scene that takes a while.
static void print_start(const SceneDescription& scene) {
  const std::vector<Problem> problems = start_problems(scene, find_start(scene));
  if (problems.empty()) return print_result("start      nothing is through anything");
  for (const Problem& problem : problems) print_result("start      will be refused: " + problem.message);
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
  print_start(run.scene);
  return static_cast<int>(ExitStatus::done);
}

}  // namespace drape::app
