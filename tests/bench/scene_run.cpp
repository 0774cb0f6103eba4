#include "scene_run.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <stdexcept>

#include "core/memory.h"
#include "core/parallel.h"
#include "machine.h"
#include "scene/load.h"
#include "simulation/scenarios.h"

namespace drape::bench {

namespace {

constexpr int frames_of_jitter = 10;

// The last three frames' positions, and the sum of their second differences.
struct Jitter {
  std::deque<std::vector<Vec3>> last;
  double squares = 0, count = 0;
};

}  // namespace

static void feel(Jitter& jitter, const std::vector<Vec3>& positions) {
  jitter.last.push_back(positions);
  if (jitter.last.size() < 3) return;
  for (std::size_t v = 0; v < positions.size(); ++v)
    jitter.squares += (jitter.last[0][v] - 2 * jitter.last[1][v] + jitter.last[2][v]).squaredNorm();
  jitter.count += static_cast<double>(positions.size());
  jitter.last.pop_front();
}

static double mass_of(const Simulation& simulation) {
  const std::vector<double> masses = test::point_masses(simulation);
  return std::accumulate(masses.begin(), masses.end(), 0.0);
}

static void advance(Simulation& simulation, SceneRun& run) {
  const double begin = wall_seconds();
  const FrameStatistics statistics = simulation.advance_frame();
  run.wall_seconds += wall_seconds() - begin;
  for (std::size_t p = 0; p < phase_names.size(); ++p)
    run.profile.cpu_seconds[p] += statistics.profile.cpu_seconds[p];
  run.contacts = std::max(run.contacts, statistics.contacts);
  run.largest_stretch = std::max(run.largest_stretch, statistics.largest_stretch);
  run.p99_stretch = std::max(run.p99_stretch, statistics.p99_stretch);
  run.smallest_stretch = std::min(run.smallest_stretch, statistics.smallest_stretch);
  run.energy_at_end = statistics.kinetic_energy;
}

static SceneRun simulate(const std::string& path, const std::vector<std::string>& overrides, int threads,
                         int frames) {
  const ThreadLimit limit(threads);
  const SceneDescription scene = load_scene(path, overrides);
  Simulation simulation(simulation_input(scene));
  SceneRun run;
  run.points = static_cast<int>(simulation.state().positions.size());
  run.steps_per_frame = simulation.steps_per_frame();
  run.frames = frames > 0 ? frames : scene.time.last_frame;
  run.seconds = run.frames / scene.time.fps;
  Jitter jitter;
  for (int frame = 1; frame <= run.frames; ++frame) {
    advance(simulation, run);
    run.intersecting_pairs += test::intersecting_pairs(simulation);
    if (frame > run.frames - frames_of_jitter) feel(jitter, simulation.state().positions);
  }
  run.jitter = std::sqrt(jitter.squares / std::max(jitter.count, 1.0));
  run.energy_at_end /= mass_of(simulation);
  return run;
}

SceneRun run_scene(const std::string& path, const std::vector<std::string>& overrides, int threads,
                   int frames) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    keep_freed_memory();
    const SceneRun run = simulate(path, overrides, threads, frames);
    _exit(write(ends[1], &run, sizeof run) == sizeof run ? 0 : 1);
  }
  close(ends[1]);
  SceneRun run;
  const bool has_come = read(ends[0], &run, sizeof run) == sizeof run;
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  if (!has_come || status != 0) throw std::runtime_error(path + " could not be simulated");
  run.memory = 1024 * usage.ru_maxrss;
  return run;
}

double cpu_seconds(const SceneRun& run) {
  return std::accumulate(run.profile.cpu_seconds.begin(), run.profile.cpu_seconds.end(), 0.0);
}

}  // namespace drape::bench
