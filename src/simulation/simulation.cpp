#include "simulation/simulation.h"

#include <algorithm>

#include "core/hash.h"
#include "simulation/colliders.h"
#include "simulation/forces.h"
#include "simulation/statistics.h"
#include "simulation/step.h"
#include "simulation/world.h"

namespace drape {

struct Simulation::Parts {
  World world;
  State state;
  Scratch scratch;
};

Simulation::Simulation(SimulationInput input) : parts_(std::make_unique<Parts>()) {
  parts_->world = build_world(std::move(input));
  parts_->state = initial_state(parts_->world);
  parts_->scratch.contact = start_contacts(parts_->world.geometry);
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;

const State& Simulation::state() const { return parts_->state; }
void Simulation::restore(State state) {
  parts_->state = std::move(state);
  parts_->scratch.contact = start_contacts(parts_->world.geometry);
}
const SimulationInput& Simulation::input() const { return parts_->world.input; }
int Simulation::steps_per_frame() const { return parts_->world.steps_per_frame; }

FrameStatistics Simulation::advance_frame() {
  World& world = parts_->world;
  State& state = parts_->state;
  Scratch& scratch = parts_->scratch;
  Profile profile;
  ContactStepResult last;
  int limited = 0;
  const double start = state.frame * world.input.frame_duration;
  update_pins(world, start);
  grab(world.pins, start, state);
  start_seams(world.seams, start, state.positions, state.seam_lengths);
  for (int i = 1; i <= world.steps_per_frame; ++i) {
    const double frames = state.frame + static_cast<double>(i) / world.steps_per_frame;
    const double time = frames * world.input.frame_duration;
    if ((i - 1) % world.steps_per_air == 0)
      timed(profile, Phase::elastic, [&] {
        feel_air(world, time - world.step, state.positions, state.velocities, scratch.air_forces);
      });
    last = advance_step(world, time, state, scratch, profile);
    limited += last.limited_vertices;
  }
  ++state.frame;

  FrameStatistics statistics = measure(world, state);
  statistics.contacts = last.contacts;
  statistics.limited_vertices = limited;
  const double now = state.frame * world.input.frame_duration;
  for (const double reached : state.collider_times)
    statistics.largest_lag = std::max(statistics.largest_lag, now - reached);
  statistics.largest_pin_lag = largest_pin_lag(world.pins, now, state);
  statistics.largest_shape_lag = largest_shape_lag(world.input.colliders, now, state.collider_points);
  statistics.profile = profile;
  return statistics;
}

static void add_vectors(Hasher& hasher, const std::vector<Vec3>& vectors) {
  hasher.add(vectors.data(), vectors.size() * sizeof(Vec3));
}

std::uint64_t state_hash(const State& state) {
  Hasher hasher;
  hasher.add(&state.frame, sizeof state.frame);
  add_vectors(hasher, state.positions);
  add_vectors(hasher, state.velocities);
  add_vectors(hasher, state.collider_points);
  hasher.add(state.collider_times.data(), state.collider_times.size() * sizeof(double));
  add_vectors(hasher, state.grabs);
  hasher.add(state.seam_lengths.data(), state.seam_lengths.size() * sizeof(double));
  hasher.add(state.remembered_contacts.data(), state.remembered_contacts.size() * sizeof(RememberedContact));
  return hasher.digest();
}

}  // namespace drape
