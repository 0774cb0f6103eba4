#pragma once

#include <string>
#include <vector>

#include "core/profile.h"

namespace drape::bench {

// What it cost to simulate a scene, and how its frames are.
struct SceneRun {
  int points = 0, steps_per_frame = 0, frames = 0;
  double seconds = 0;  // simulated
  double wall_seconds = 0;
  Profile profile;             // CPU seconds of all threads
  int contacts = 0;            // the most at the end of a frame
  int intersecting_pairs = 0;  // over all frames
  double largest_stretch = 1, p99_stretch = 1, smallest_stretch = 1;
  double jitter = 0;         // m: rms of what points of the last frames do beyond moving on steadily
  double energy_at_end = 0;  // J/kg, kinetic
  long memory = 0;           // bytes, the most that was resident
};

// Simulates the scene in a process of its own, so that its memory is its own too. Judging the frames is not
// part of any time. frames: 0 for all of the scene's.
SceneRun run_scene(const std::string& path, const std::vector<std::string>& overrides, int threads,
                   int frames = 0);

double cpu_seconds(const SceneRun& run);

}  // namespace drape::bench
