#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/profile.h"
#include "simulation/input.h"

namespace drape {

// All that changes from step to step: what a hash and a checkpoint cover.
struct State {
  int frame = 0;  // frames advanced; the time is frame * frame_duration
  std::vector<Vec3> positions;   // of all cloths, one after another
  std::vector<Vec3> velocities;
  std::vector<RigidPose> collider_poses;
};
std::uint64_t state_hash(const State& state);

struct FrameStatistics {
  double largest_stretch = 1;  // edge length over rest length
  double p99_stretch = 1;
  double smallest_stretch = 1;
  int contacts = 0;            // active at the frame's last step
  double kinetic_energy = 0;   // J
  double largest_speed = 0;    // m/s
  Profile profile;             // CPU seconds of this frame
};

class Simulation {
 public:
  explicit Simulation(SimulationInput input);
  ~Simulation();
  Simulation(Simulation&&) noexcept;

  FrameStatistics advance_frame();  // throws SimulationError where values are no longer finite
  const State& state() const;
  void restore(State state);        // goes on from a checkpoint of the same input
  const SimulationInput& input() const;
  int steps_per_frame() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace drape
