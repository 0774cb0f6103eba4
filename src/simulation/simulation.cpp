#include "simulation/simulation.h"

#include "core/hash.h"
#include "simulation/forces.h"
#include "simulation/rest.h"
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

// All steps of the frame that comes after the state. Returns how many vertices the fail-safe held back in
// them.
static int advance_steps(const World& world, State& state, Scratch& scratch, Profile& profile) {
  int limited = 0;
  for (int i = 1; i <= world.steps_per_frame; ++i) {
    const double frames = state.frame + static_cast<double>(i) / world.steps_per_frame;
    const double time = frames * world.input.frame_duration;
    if ((i - 1) % world.steps_per_air == 0)
      timed(profile, Phase::elastic, [&] {
        feel_air(world, time - world.step, state.positions, state.velocities, scratch.air_forces);
      });
    const ContactStepResult contact = advance_step(world, time, state, scratch, profile);
    state.contacts = contact.contacts;
    limited += contact.limited_vertices;
  }
  ++state.frame;
  return limited;
}

static int advance_awake(bool stirred, World& world, State& state, Scratch& scratch, Profile& profile) {
  const double start = state.frame * world.input.frame_duration;
  update_pins(world, start);
  grab(world.pins, start, state);
  start_seams(world.seams, start, state.positions, state.seam_lengths);
  const int limited = advance_steps(world, state, scratch, profile);
  watch_stillness(world, stirred, state);
  return limited;
}

FrameStatistics Simulation::advance_frame() {
  World& world = parts_->world;
  State& state = parts_->state;
  Profile profile;
  int limited = 0;
  const bool stirred = is_stirred(world, state);
  if (!stirred && lies_still(world, state))
    stay(world, state);
  else
    limited = advance_awake(stirred, world, state, parts_->scratch, profile);
  FrameStatistics statistics = measure(world, state);
  statistics.limited_vertices = limited;
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
  hasher.add(&state.contacts, sizeof state.contacts);
  add_vectors(hasher, state.still_positions);
  add_vectors(hasher, state.later_positions);
  hasher.add(&state.still_since, sizeof state.still_since);
  return hasher.digest();
}

}  // namespace drape
