#include "simulation/rest.h"

#include <algorithm>
#include <cmath>

#include "simulation/colliders.h"
#include "simulation/wind.h"

namespace drape {
namespace {

constexpr double same_time = 1e-9;  // s: what differs by rounding

// From `begin` to `end`, in seconds.
struct Frame {
  double begin, end;
};

Frame next_frame(const World& world, const State& state) {
  const double duration = world.input.frame_duration;
  return {state.frame * duration, (state.frame + 1) * duration};
}

// Of something that goes on only between two times.
bool is_within(const Frame& frame, double from, double until) {
  return frame.end > from + same_time && frame.begin < until - same_time;
}

bool moves(const ColliderInput& collider, const Frame& frame) {
  if (moves_between(collider.motion, frame.begin, frame.end)) return true;
  if (!deforms(collider)) return false;
  const MeshShape& mesh = std::get<MeshShape>(collider.shape);
  const double duration = static_cast<double>(mesh.shapes.size() - 1) * mesh.interval;
  return is_within(frame, mesh.first_time, mesh.first_time + duration);
}

bool is_moving_collider(const World& world, const State& state, const Frame& frame) {
  const std::vector<ColliderInput>& colliders = world.input.colliders;
  constexpr double same_place = 1e-9;  // m
  return std::any_of(colliders.begin(), colliders.end(),
                     [&](const ColliderInput& collider) { return moves(collider, frame); }) ||
         std::any_of(state.collider_times.begin(), state.collider_times.end(),
                     [&](double reached) { return reached < frame.begin - same_time; }) ||
         largest_shape_lag(colliders, frame.begin, state.collider_points) > same_place;
}

bool is_changing_pin(const World& world, const Frame& frame) {
  const std::size_t count = world.masses.size();
  return std::any_of(world.pins.begin(), world.pins.end(),
                     [&](const Pin& pin) {
                       return pin.motion && moves_between(*pin.motion, frame.begin, frame.end);
                     }) ||
         pinned_vertices(world.pins, count, frame.begin - world.input.frame_duration) !=
             pinned_vertices(world.pins, count, frame.begin);
}

bool is_drawing_seam(const World& world, const Frame& frame) {
  return std::any_of(world.seams.seams.begin(), world.seams.seams.end(),
                     [&](const Seam& seam) { return is_within(frame, seam.from, seam.close); });
}

bool has_moved(const World& world, const State& state) {
  constexpr double share = 0.02;  // of an edge
  const double most = share * mean_edge_length(world.sheet);
  for (std::size_t v = 0; v < state.positions.size(); ++v)
    if ((state.positions[v] - state.still_positions[v]).norm() > most) return true;
  return false;
}

}  // namespace

bool is_stirred(const World& world, const State& state) {
  const Frame frame = next_frame(world, state);
  const WindInput& wind = world.input.wind;
  return (has_air(wind) && !is_steady(wind)) || is_changing_pin(world, frame) ||
         is_drawing_seam(world, frame) || is_moving_collider(world, state, frame);
}

bool lies_still(const World& world, const State& state) {
  constexpr double least_duration = 0.5;  // s
  constexpr int least_frames = 5;         // or what swings in time with the frames would look still
  const int frames = state.frame - state.still_since;
  return world.input.sleep && frames >= least_frames &&
         frames * world.input.frame_duration > least_duration - same_time;
}

void watch_stillness(const World& world, bool stirred, State& state) {
  if (!stirred && !has_moved(world, state)) return;
  state.still_positions = state.positions;
  state.still_since = state.frame;
}

void stay(const World& world, State& state) {
  std::fill(state.velocities.begin(), state.velocities.end(), Vec3::Zero());
  const double end = next_frame(world, state).end;
  for (double& reached : state.collider_times) reached = end;
  ++state.frame;
}

}  // namespace drape
