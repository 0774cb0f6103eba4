#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/rigid_motion.h"
#include "core/vector.h"
#include "simulation/simulation.h"

namespace drape {

// The cache is a folder: frame_0001.drape ... (what pictures are drawn from: floats), and checkpoint.drape
// (the last whole state in double, from which a simulation goes on). Files are zstd, carry a hash of their
// content and the fingerprint of what they were made from (the scene's settings that the simulation depends
// on), and are written whole or not at all.

struct CachedFrame {
  int frame = 0;
  std::uint64_t state_hash = 0;
  std::vector<Vec3f> positions;  // of all cloths, one after another
  std::vector<RigidPose> collider_poses;
  std::vector<Vec3f> collider_points;  // in the world, of the colliders that deform, one after another
};

CachedFrame to_cached_frame(const State& state, const std::vector<ColliderInput>& colliders);

std::filesystem::path cached_frame_path(const std::filesystem::path& folder, int frame);
void write_cached_frame(const std::filesystem::path& folder, std::uint64_t fingerprint,
                        const CachedFrame& frame);
// Throws FileError where the file is missing, damaged (hash), or made from something else (fingerprint); the
// message says which, and what to run.
CachedFrame read_cached_frame(const std::filesystem::path& folder, std::uint64_t fingerprint, int frame);

void write_checkpoint(const std::filesystem::path& folder, std::uint64_t fingerprint, const State& state);
// Nothing where there is none, or it was made from something else. Throws FileError where it is damaged.
std::optional<State> read_checkpoint(const std::filesystem::path& folder, std::uint64_t fingerprint);

}  // namespace drape
