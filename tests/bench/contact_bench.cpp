// What contact costs, and what comes of it: two scenes with one thread and two, and how the cost of a step
// grows with the number of points.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "machine.h"
#include "scene_run.h"

namespace drape::bench {

static void print_heading() {
  fmt::print("| scene | threads | CPU s per simulated s");
  for (const std::string_view phase : phase_names) fmt::print(" | {}", phase);
  fmt::print(
      " | CPU s, all | wall s | contacts | intersecting pairs | largest stretch | p99 | smallest | jitter |"
      " energy at the end | memory |\n|");
  for (std::size_t i = 0; i < 13 + phase_names.size(); ++i) fmt::print("---|");
  fmt::print("\n");
}

static void print_row(const std::string& name, int threads, const SceneRun& run) {
  fmt::print("| {}, {} points, {} frames of {} steps | {} | {:.2f}", name, run.points, run.frames,
             run.steps_per_frame, threads, cpu_seconds(run) / run.seconds);
  for (const double phase : run.profile.cpu_seconds) fmt::print(" | {:.2f}", phase / run.seconds);
  fmt::print(" | {:.1f} | {:.1f} | {} | {} | {:.4f} | {:.4f} | {:.4f} | {:.1f} um | {:.1e} J/kg | {} MB |\n",
             cpu_seconds(run), run.wall_seconds, run.contacts, run.intersecting_pairs, run.largest_stretch,
             run.p99_stretch, run.smallest_stretch, 1e6 * run.jitter, run.energy_at_end, run.memory >> 20);
  std::fflush(stdout);
}

static void compare_threads(const std::string& name, const std::string& path) {
  const SceneRun one = run_scene(path, {}, 1);
  print_row(name, 1, one);
  const SceneRun two = run_scene(path, {}, 2);
  print_row(name, 2, two);
  fmt::print("{}: two threads take 1/{:.2f} of the wall time of one\n\n", name,
             one.wall_seconds / two.wall_seconds);
}

// The sheet of sphere_drape in finer meshes, as thick in proportion to their edges, as it comes down on the
// ball.
static void grow(const std::string& path) {
  constexpr int first_frames = 8;
  fmt::print(
      "| points | steps of a frame | CPU ms a step | contacts | ns a step and point | against the first |\n"
      "|---|---|---|---|---|---|\n");
  double first = 0;
  for (const int side : {71, 100, 141, 224, 316}) {
    const SceneRun run = run_scene(path,
                                   {fmt::format("cloths.sheet.grid.points=[{0}, {0}]", side),
                                    fmt::format("cloths.sheet.material.thickness={:.4g}", 0.005 * 71 / side)},
                                   1, first_frames);
    const double step = cpu_seconds(run) / (run.frames * run.steps_per_frame), each = step / run.points;
    if (first == 0) first = each;
    fmt::print("| {} | {} | {:.2f} | {} | {:.0f} | {:.2f} |\n", run.points, run.steps_per_frame, 1e3 * step,
               run.contacts, 1e9 * each, each / first);
    std::fflush(stdout);
  }
}

}  // namespace drape::bench

int main() {
  using namespace drape::bench;
  const std::string scenes = DRAPE_SOURCE_DIR "/scenes/";
  fmt::print("{}\n\n", machine_name());
  print_heading();
  compare_threads("sphere_drape", scenes + "sphere_drape.yaml");
  print_heading();
  compare_threads("edge_first", scenes + "contact/edge_first.yaml");
  grow(scenes + "sphere_drape.yaml");
}
