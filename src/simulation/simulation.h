#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "contact/contact_memory.h"
#include "core/profile.h"
#include "simulation/input.h"

namespace drape {

// All that changes from step to step: what a hash and a checkpoint cover.
struct State {
  int frame = 0;                       // frames advanced; the time is frame * frame_duration
  std::vector<Vec3> positions;         // of all cloths, one after another, in m
  std::vector<Vec3> velocities;        // m/s
  std::vector<Vec3> collider_points;   // the vertices of all colliders, where they really are
  std::vector<double> collider_times;  // seconds: how far each collider has come on its way; a collider that
                                       // cloth holds up lags behind the state's time, and catches up
  std::vector<RigidPose> collider_poses;  // the poses at these times: what is drawn
  std::vector<Vec3> grabs;                // where the vertices of all pins were grabbed (pins.h); zero before
  std::vector<double> seam_lengths;       // m: how long the threads of all seams were at first; zero before
  std::vector<RememberedContact> remembered_contacts;  // what contacts keep of the last step
  int contacts = 0;                                    // of the last step
  int still_since = 0;                                 // frame: cloth has lain still since its end (rest.h)
  std::vector<Vec3> still_positions;  // m: the places of its points then, or a sixth of a second later
  std::vector<Vec3> later_positions;  // and a sixth of a second after that
};
std::uint64_t state_hash(const State& state);

struct FrameStatistics {
  double largest_stretch = 1;  // edge length over rest length
  double p99_stretch = 1;
  double smallest_stretch = 1;
  int contacts = 0;              // at the frame's last step
  int limited_vertices = 0;      // summed over the frame's steps: vertices that the fail-safe held back
  double kinetic_energy = 0;     // J
  double largest_speed = 0;      // m/s
  double largest_lag = 0;        // seconds that a collider is behind its keyframes
  double largest_pin_lag = 0;    // m that a pinned vertex is from where its pin would have it
  double largest_shape_lag = 0;  // m that a point of a deforming collider is from where its shapes have it
  Profile profile;               // CPU seconds of this frame
};

// A simulation of one scene: the same input gives the same bits with any number of threads.
class Simulation {
 public:
  explicit Simulation(SimulationInput input);
  ~Simulation();
  Simulation(Simulation&&) noexcept;

  FrameStatistics advance_frame();  // throws SimulationError where values are no longer finite
  const State& state() const;
  void restore(State state);  // goes on from a checkpoint of the same input
  const SimulationInput& input() const;
  int steps_per_frame() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace drape
