// Simulates scenes and prints, every thirtieth frame, what a reader of the paper would ask for: stretch,
// contacts, intersecting pairs of triangles; then CPU seconds by phase. Scenes are its arguments.

#include <fmt/format.h>

#include "core/hash.h"
#include "core/memory.h"
#include "scene/load.h"
#include "simulation/scenarios.h"

namespace drape {
namespace {

void print_frame(const Simulation& simulation, const FrameStatistics& s) {
  fmt::print("{:5} {:9} {:8} {:8.4f} {:8.4f} {:8.4f} {:10.2e} {:8.4f} {:8} {:6}\n", simulation.state().frame,
             s.contacts, s.limited_vertices, s.largest_stretch, s.p99_stretch, s.smallest_stretch,
             s.kinetic_energy, s.largest_speed, test::intersecting_pairs(simulation),
             to_hex(state_hash(simulation.state())).substr(0, 8));
}

void report(const char* path) {
  const SceneDescription scene = load_scene(path);
  Simulation simulation(simulation_input(scene));
  fmt::print("{}: {} points, {} steps a frame\n", path, simulation.state().positions.size(),
             simulation.steps_per_frame());
  fmt::print("frame  contacts held back  largest      p99 smallest     energy    speed    pairs   hash\n");
  Profile total;
  for (int frame = 1; frame <= scene.time.last_frame; ++frame) {
    const FrameStatistics statistics = simulation.advance_frame();
    for (std::size_t p = 0; p < phase_names.size(); ++p)
      total.cpu_seconds[p] += statistics.profile.cpu_seconds[p];
    if (frame == 1 || frame % 30 == 0) print_frame(simulation, statistics);
  }
  double sum = 0;
  for (std::size_t p = 0; p < phase_names.size(); ++p) {
    fmt::print("{:>10} {:8.2f} CPU s\n", phase_names[p], total.cpu_seconds[p]);
    sum += total.cpu_seconds[p];
  }
  fmt::print("{:>10} {:8.2f} CPU s\n\n", "all", sum);
}

}  // namespace
}  // namespace drape

int main(int count, char** arguments) {
  drape::keep_freed_memory();
  for (int i = 1; i < count; ++i) drape::report(arguments[i]);
  if (count == 1) drape::report(DRAPE_SOURCE_DIR "/scenes/sphere_drape.yaml");
}
