#include "simulation/rest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/same_time.h"
#include "simulation/colliders.h"
#include "simulation/wind.h"

namespace drape {
namespace {

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

// One that takes over from another changes nothing but what it grabs.
bool changes(const Pin& pin, const Frame& frame) {
  const auto is_now = [&](double time) { return std::abs(time - frame.begin) < same_time; };
  if (is_now(pin.from) || (pin.until && is_now(*pin.until))) return true;
  return pin.motion && holds(pin, frame.begin) && moves_between(*pin.motion, frame.begin, frame.end);
}

bool is_changing_pin(const World& world, const Frame& frame) {
  return std::any_of(world.pins.begin(), world.pins.end(),
                     [&](const Pin& pin) { return changes(pin, frame); });
}

bool is_drawing_seam(const World& world, const Frame& frame) {
  return std::any_of(world.seams.seams.begin(), world.seams.seams.end(),
                     [&](const Seam& seam) { return is_within(frame, seam.from, seam.close); });
}

// Of half a second, in frames; three at least, or what swings in time with them would look still.
int third_of_window(const World& world) {
  constexpr double window = 0.5;  // s
  constexpr int least = 3;
  return std::max(least, static_cast<int>(std::ceil(window / 3 / world.input.frame_duration - same_time)));
}

double largest_way(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  double largest = 0;
  for (std::size_t v = 0; v < from.size(); ++v) largest = std::max(largest, (to[v] - from[v]).squaredNorm());
  return std::sqrt(largest);
}

// Whether the way of the window's last third is longer than that of the one before, by more than chance:
// a sheet that falls over starts as slowly as one that comes to rest ends.
bool gathers_speed(const World& world, const State& state) {
  constexpr double chance = 0.01;  // of the way in which points lie still
  const double last = largest_way(state.later_positions, state.positions);
  return last > chance * world.still_way && last > largest_way(state.still_positions, state.later_positions);
}

// Whether a piece of cloth has neither a pin nor a contact that would keep it where it is.
bool is_afloat(const World& world, const State& state) {
  std::vector<char> is_held(world.geometry.vertex_body.size(), 0);
  for (const RememberedContact& contact : state.remembered_contacts)
    for (const int v : contact.vertices) is_held[v] = 1;
  return std::any_of(world.free_pieces.begin(), world.free_pieces.end(), [&](const FreePiece& piece) {
    return std::none_of(piece.vertices.begin(), piece.vertices.end(), [&](int v) { return is_held[v] != 0; });
  });
}

void begin_anew(State& state) {
  state.still_positions = state.later_positions = state.positions;
  state.still_since = state.frame;
}

// The first counts for nothing but the way: what settles in it would hide what gathers speed.
void pass_third(const World& world, int thirds, State& state) {
  if (thirds == 3 && !gathers_speed(world, state) && !is_afloat(world, state)) return;
  state.still_positions = std::exchange(state.later_positions, state.positions);
  if (thirds == 3) state.still_since += third_of_window(world);
}

}  // namespace

double largest_still_way(const Sheet& sheet) {
  constexpr double share = 0.02, most = 0.0005;  // of an edge; m
  double shortest = std::numeric_limits<double>::infinity();
  for (const double length : mean_edge_lengths(sheet)) shortest = std::min(shortest, length);
  return std::min(share * shortest, most);
}

bool is_stirred(const World& world, const State& state) {
  const Frame frame = next_frame(world, state);
  const WindInput& wind = world.input.wind;
  return (has_air(wind) && !is_steady(wind)) || is_changing_pin(world, frame) ||
         is_drawing_seam(world, frame) || is_moving_collider(world, state, frame);
}

bool lies_still(const World& world, const State& state) {
  return world.input.sleep && state.frame - state.still_since >= 3 * third_of_window(world);
}

void watch_stillness(const World& world, bool stirred, State& state) {
  const int third = third_of_window(world), frames = state.frame - state.still_since;
  if (stirred || largest_way(state.still_positions, state.positions) > world.still_way)
    begin_anew(state);
  else if (frames % third == 0 && frames <= 3 * third)
    pass_third(world, frames / third, state);
}

void stay(const World& world, State& state) {
  std::fill(state.velocities.begin(), state.velocities.end(), Vec3::Zero());
  const double end = next_frame(world, state).end;
  for (double& reached : state.collider_times) reached = end;
  ++state.frame;
}

}  // namespace drape
