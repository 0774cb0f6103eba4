#include "app/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "app/capsule.h"
#include "app/frame_certificate.h"
#include "app/interrupt.h"
#include "app/program.h"
#include "app/progress.h"
#include "app/stage_timer.h"
#include "app/start.h"
#include "core/error.h"
#include "core/parallel.h"
#include "scene/load.h"
#include "simulation/cache.h"
#include "simulation/simulation.h"

namespace drape::app {
namespace fs = std::filesystem;

// Whether every frame up to the state's is in the cache, whole and made from this scene.
static bool cache_reaches(const Run& run, const State& state) {
  for (int frame = run.scene.time.first_frame; frame <= state.frame; ++frame) {
    if (!run.manifest.frames.contains(frame)) return false;
    try {
      const CachedFrame cached = read_cached_frame(run.folder.cache(), run.manifest.fingerprint, frame);
      if (cached.state_hash != run.manifest.frames.at(frame).state_hash) return false;
    } catch (const FileError&) {
      return false;
    }
  }
  return true;
}

// A damaged checkpoint is worth no more than none: what it held can be simulated again.
static std::optional<State> find_checkpoint(const Run& run, const Console& console) {
  try {
    return read_checkpoint(run.folder.cache(), run.manifest.fingerprint);
  } catch (const FileError& error) {
    warn(console, error.what());
    return std::nullopt;
  }
}

// A checkpoint that nothing speaks against going on from.
static std::optional<State> state_to_resume(const Run& run, const Options& options, const Console& console) {
  if (options.overwrite) return std::nullopt;
  auto state = find_checkpoint(run, console);
  if (!state) return std::nullopt;
  if (run.manifest.build != program_build() && !options.resume) {
    note(console,
         "the cache was made by another build of drape: starting anew (--resume would go on from it)");
    return std::nullopt;
  }
  if (cache_reaches(run, *state)) return state;
  note(console, "frames are missing from the cache, or damaged: starting anew");
  return std::nullopt;
}

static bool is_cache_file(const fs::path& path) {
  std::string name = path.filename().string();
  name = name.substr(0, name.find(".part"));  // what a crash left half-written
  return name == "checkpoint.drape" || (name.starts_with("frame_") && name.ends_with(".drape"));
}

// Only what Drape itself writes there: -o may name a folder with a cache of something else.
static std::vector<fs::path> cache_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (is_cache_file(entry.path())) files.push_back(entry.path());
  }
  if (error && error != std::errc::no_such_file_or_directory)
    throw FileError(folder.string(), "cannot be read: " + error.message());
  return files;
}

// Old frames go before new ones come, so that a stop in between cannot leave a mixture.
static void forget_earlier_work(Run& run) {
  run.manifest.frames.clear();
  run.manifest.stages.clear();
  for (const fs::path& file : cache_files(run.folder.cache())) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw FileError(file.string(), "cannot be removed: " + error.message());
  }
}

namespace {

// Keeps what is on disk close behind the simulation. Each frame goes into the cache at once; the record and
// the checkpoint follow once a second, since they are rewritten as a whole and a second is soon simulated
// again. The record goes first: it must know every frame that the checkpoint has left behind.
class Keeper {
 public:
  explicit Keeper(Run& run) : run_(run) {}

  void keep(const State& state, const CachedFrame& frame, const FrameStatistics& statistics) {
    if (state.frame >= run_.scene.time.first_frame) {
      write_cached_frame(run_.folder.cache(), run_.manifest.fingerprint, frame);
      run_.manifest.frames[frame.frame] = {frame.state_hash, statistics, 0};
    }
    if (Clock::now() - saved_ >= std::chrono::seconds(1)) save(state);
  }

  void save(const State& state) {
    write_manifest(run_.folder.manifest(), run_.manifest);
    write_checkpoint(run_.folder.cache(), run_.manifest.fingerprint, state);
    saved_ = Clock::now();
  }

 private:
  using Clock = std::chrono::steady_clock;

  Run& run_;
  Clock::time_point saved_ = Clock::now();
};

}  // namespace

namespace {

struct Advanced {
  FrameStatistics statistics;
  CachedFrame frame;
  std::string failure;  // why the frame is none; empty: it is good
};

}  // namespace

static Advanced try_to_advance(Simulation& simulation) {
  try {
    return {simulation.advance_frame(), {}, ""};
  } catch (const SimulationError& error) {
    return {{}, {}, error.what()};
  }
}

// No frame is kept that is not certified.
static Advanced advance(Simulation& simulation, const Run& run, const CertifiedScene& scene, Keeper& keeper) {
  const State before = simulation.state();
  Advanced advanced = try_to_advance(simulation);
  advanced.frame = to_cached_frame(simulation.state(), simulation.input().colliders);
  CertifiedSurface certified = certify_simulated(scene, advanced.frame);
  if (advanced.failure.empty() && is_clean(certified)) return advanced;
  if (advanced.failure.empty()) advanced.failure = "something is through something";
  keeper.save(before);
  stop_with_capsule(run, {before, simulation.state(), std::move(certified), advanced.failure});
}

static void advance_to_last_frame(Simulation& simulation, Run& run, const Console& console) {
  const int last = run.scene.time.last_frame;
  const CertifiedScene scene = prepare_certificate(run.scene);
  Progress progress(console, "simulate", last, simulation.state().frame);
  Keeper keeper(run);
  while (simulation.state().frame < last && stop_signal() == 0) {
    const Advanced advanced = advance(simulation, run, scene, keeper);
    keeper.keep(simulation.state(), advanced.frame, advanced.statistics);
    progress.update(simulation.state().frame, advanced.statistics.contacts);
  }
  keeper.save(simulation.state());
}

namespace {

// The worst of a figure over all frames.
struct Worst {
  double value = 0;
  int frame = 0;
};

}  // namespace

static Worst worst_of(const Run& run, double FrameStatistics::*figure) {
  Worst worst;
  for (const auto& [frame, record] : run.manifest.frames)
    if (record.statistics.*figure > worst.value) worst = {record.statistics.*figure, frame};
  return worst;
}

// What did not go where its keyframes say, because cloth or a collider was in the way.
static void tell_lags(const Run& run, const Console& console) {
  constexpr double seconds_noticed = 0.01, metres_noticed = 0.001;
  const Worst collider = worst_of(run, &FrameStatistics::largest_lag),
              pin = worst_of(run, &FrameStatistics::largest_pin_lag),
              shape = worst_of(run, &FrameStatistics::largest_shape_lag);
  if (collider.value > seconds_noticed)
    warn(console, fmt::format("cloth holds a collider up: in frame {} it is {:.3g} s behind its keyframes",
                              collider.frame, collider.value));
  if (pin.value > metres_noticed)
    warn(console,
         fmt::format("something is in the way of a pin: in frame {} its vertices are up to {:.3g} mm from "
                     "where it would have them",
                     pin.frame, 1000 * pin.value));
  if (shape.value > metres_noticed)
    warn(console,
         fmt::format("cloth is in the way of a collider's shape: in frame {} its points are up to {:.3g} "
                     "mm from where the files have them",
                     shape.frame, 1000 * shape.value));
}

// Who wonders why the rest of a run was so quick is told.
static void tell_sleep(const Run& run, const Console& console) {
  const auto& frames = run.manifest.frames;
  const auto slept = std::count_if(frames.begin(), frames.end(), [](const auto& frame) {
    return frame.second.statistics.profile.cpu_seconds == Profile().cpu_seconds;
  });
  if (slept > 0)
    note(console, fmt::format("simulate  cloth lay still in {} of {} frames, which took no step", slept,
                              frames.size()));
}

// What a refused start costs is not the frames of an earlier one.
static Simulation start_anew(Run& run) {
  SimulationInput input = start_input(run.scene, run.folder.root);
  forget_earlier_work(run);
  return Simulation(std::move(input));
}

static void simulate_from(std::optional<State> checkpoint, Run& run, const Console& console) {
  Simulation simulation = checkpoint ? Simulation(simulation_input(run.scene)) : start_anew(run);
  const StageTimer timer(run.manifest.stages["simulate"]);
  if (checkpoint) {
    note(console, fmt::format("simulate  goes on after frame {}", checkpoint->frame));
    simulation.restore(std::move(*checkpoint));
  }
  advance_to_last_frame(simulation, run, console);
  tell_lags(run, console);
  tell_sleep(run, console);
}

void simulate(Run& run, const Options& options, const Console& console) {
  const ThreadLimit limit(options.threads);
  auto checkpoint = state_to_resume(run, options, console);
  if (checkpoint && checkpoint->frame >= run.scene.time.last_frame) {
    note(console, "simulate  every frame is in the cache already");
  } else {
    if (!checkpoint && !options.overwrite) refuse_folder_of_other_scene(run);
    run.manifest.certificate.reset();  // it was of other frames
    run.manifest.build = program_build();
    run.manifest.threads = options.threads;
    simulate_from(std::move(checkpoint), run, console);
  }
  write_manifest(run.folder.manifest(), run.manifest);
  throw_if_stopped();
}

}  // namespace drape::app
