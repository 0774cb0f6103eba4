#include "simulation/step.h"

#include <algorithm>
#include <atomic>
#include <span>

#include "core/error.h"
#include "core/parallel.h"
#include "simulation/colliders.h"
#include "simulation/come_after.h"
#include "simulation/forces.h"

namespace drape {
namespace {

// A collider that was held up catches up at this multiple of its own pace.
constexpr double catch_up = 1.5;

constexpr std::size_t block = 1024;

void copy_points(const std::vector<Vec3>& from, std::vector<Vec3>& to) {
  parallel_for_each(from.size(), block, [&](std::size_t v) { to[v] = from[v]; });
}

// Where every vertex is before the step, and (for now) colliders after it: cloth has no end yet.
void gather_start(const State& state, Scratch& scratch) {
  const std::size_t count = state.positions.size();
  scratch.start.resize(count + state.collider_points.size());
  scratch.end.resize(scratch.start.size());
  copy_points(state.positions, scratch.start);
  for (std::size_t i = 0; i < state.collider_points.size(); ++i)
    scratch.start[count + i] = scratch.end[count + i] = state.collider_points[i];
}

// A rigid collider makes for its pose at `time`, or what of it it can catch up with. It does not go past a
// key in one step: where it is held on its way, its points and its clock must tell the same pose.
void aim_rigid(const World& world, std::size_t c, double time, const State& state, Scratch& scratch,
               Vec3* points) {
  const RigidMotion& motion = world.input.colliders[c].motion;
  const double reached = state.collider_times[c];
  scratch.collider_aims[c] = std::min({time, reached + catch_up * world.step, next_key(motion, reached)});
  BodyMotion& body = scratch.bodies[world.input.cloths.size() + c];
  body = {pose_at(motion, reached), pose_at(motion, scratch.collider_aims[c])};
  for (const Vec3& local : world.collider_points[c]) *points++ = body.end(local);
}

// One that deforms makes for its shape at `time`, and each of its points catches up by itself.
void aim_shape(const World& world, std::size_t c, double time, Scratch& scratch, Vec3* points) {
  const ColliderInput& collider = world.input.colliders[c];
  const std::vector<Vec3> from = collider_points(collider, time - world.step),
                          to = collider_points(collider, time);
  scratch.collider_aims[c] = time;
  for (std::size_t i = 0; i < to.size(); ++i) points[i] = come_after(points[i], from[i], to[i], world.step);
}

void aim_colliders(const World& world, double time, const State& state, Scratch& scratch) {
  scratch.bodies.assign(world.geometry.bodies.size(), {});
  scratch.collider_aims.resize(world.input.colliders.size());
  Vec3* points = scratch.end.data() + state.positions.size();
  for (std::size_t c = 0; c < world.input.colliders.size(); ++c) {
    if (deforms(world.input.colliders[c]))
      aim_shape(world, c, time, scratch, points);
    else
      aim_rigid(world, c, time, state, scratch, points);
    points += world.collider_points[c].size();
  }
}

// Sections 3 and 4: external forces, and x -> x**. Pieces that nothing holds keep their momenta (but
// in the paper's own form, which leaves that open).
void move_without_contact(const World& world, double time, const State& state, Scratch& scratch) {
  external_accelerations(world, scratch.air_forces, state.positions, scratch.accelerations);
  scratch.free_positions.resize(state.positions.size());
  scratch.free_velocities.resize(state.positions.size());
  copy_points(state.positions, scratch.free_positions);
  copy_points(state.velocities, scratch.free_velocities);
  const auto colliders = std::span<const BodyMotion>(scratch.bodies).subspan(world.input.cloths.size());
  place_pinned(world.pins, time - world.step, time, state, colliders, scratch.free_positions);
  move_freely(world.model, scratch.accelerations, world.step, world.pinned, state.positions,
              scratch.free_motion, scratch.free_positions, scratch.free_velocities);
  if (world.input.model != DeformationModel::shape_matching) return;
  for (const FreePiece& piece : world.free_pieces)
    restore_momenta(piece, world.masses, state.positions, state.velocities, scratch.accelerations, world.step,
                    scratch.free_positions, scratch.free_velocities);
}

// What seams pull shut is way and velocity both.
void sew_shut(const World& world, double time, const State& state, Scratch& scratch) {
  if (world.seams.seams.empty()) return;
  scratch.unsewn_positions = scratch.free_positions;
  pull_seams(world.seams, state.seam_lengths, world.geometry.inverse_masses, time, scratch.free_positions);
  for (std::size_t v = 0; v < state.positions.size(); ++v)
    scratch.free_velocities[v] += (scratch.free_positions[v] - scratch.unsewn_positions[v]) / world.step;
}

void check_finite(const std::vector<Vec3>& x) {
  std::atomic<bool> finite = true;
  parallel_for_each(x.size(), block, [&](std::size_t v) {
    if (!x[v].allFinite()) finite.store(false, std::memory_order_relaxed);
  });
  if (!finite) throw SimulationError("the positions are no longer finite numbers: try a smaller time step");
}

// Re-integration (section 5): what contact has moved is velocity too, but for its push; colliders to where
// they came.
void integrate(const World& world, const ContactStepResult& contact, State& state, Scratch& scratch) {
  const std::size_t count = state.positions.size();
  parallel_for_each(count, block, [&](std::size_t v) {
    state.velocities[v] = scratch.free_velocities[v] +
                          (scratch.end[v] - scratch.free_positions[v] - contact.push[v]) / world.step;
    state.positions[v] = scratch.end[v];
  });
  state.collider_points.assign(scratch.end.begin() + static_cast<std::ptrdiff_t>(count), scratch.end.end());
  for (std::size_t c = 0; c < state.collider_times.size(); ++c) {
    const double share = contact.body_progress[world.input.cloths.size() + c];
    double& reached = state.collider_times[c];
    reached = share < 1 ? reached + share * (scratch.collider_aims[c] - reached) : scratch.collider_aims[c];
    state.collider_poses[c] = collider_pose(world.input.colliders[c], reached);
  }
}

}  // namespace

ContactStepResult advance_step(const World& world, double time, State& state, Scratch& scratch,
                               Profile& profile) {
  timed(profile, Phase::other, [&] {
    gather_start(state, scratch);
    aim_colliders(world, time, state, scratch);
  });
  timed(profile, Phase::elastic, [&] {
    move_without_contact(world, time, state, scratch);
    sew_shut(world, time, state, scratch);
    copy_points(scratch.free_positions, scratch.end);
  });
  check_finite(scratch.end);
  ContactStepResult contact =
      step_contacts(world.geometry, world.contact_settings, scratch.bodies, scratch.start, scratch.contact,
                    state.remembered_contacts, profile, scratch.end);
  check_finite(scratch.end);
  timed(profile, Phase::other, [&] { integrate(world, contact, state, scratch); });
  return contact;
}

}  // namespace drape
