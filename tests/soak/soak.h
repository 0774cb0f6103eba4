#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace drape::soak {

// How a random scene went, every frame of it judged as `drape verify` does.
struct Outcome {
  std::string fault;  // in words, with the frame; empty: every frame is certified
  int points = 0, frames = 0;
  double largest_stretch = 1;
  double smallest_gap = 0;  // m
  int held_back = 0;        // vertices, over all steps
};

// Writes the scene of the seed as soak_SEED.yaml into the folder, and simulates it. A scene that starts
// through something is left out: no frames, and no fault.
Outcome soak_scene(std::uint64_t seed, const std::filesystem::path& folder);

}  // namespace drape::soak
