#include "simulation/pins.h"

#include <algorithm>
#include <cmath>

#include "core/same_time.h"
#include "simulation/come_after.h"

namespace drape {
namespace {

Vec3 into_frame(const RigidPose& frame, const Vec3& point) {
  return frame.rotation.transpose() * (point - frame.translation);
}

// Where the grabbed points go: by what the motion has changed since the grab, turning about their centroid.
RigidPose way_since_grab(const Pin& pin, double time, std::span<const Vec3> grabs) {
  Vec3 centroid = Vec3::Zero();
  for (const Vec3& point : grabs) centroid += point / static_cast<double>(grabs.size());
  const RigidPose now = pose_at(*pin.motion, time), then = pose_at(*pin.motion, pin.from);
  const Mat3 turn = now.rotation * then.rotation.transpose();
  return {turn, centroid - turn * centroid + now.translation - then.translation};
}

}  // namespace

bool holds(const Pin& pin, double time) {
  return time > pin.from - same_time && (!pin.until || time < *pin.until - same_time);
}

std::vector<Pin> build_pins(const std::vector<ClothInput>& cloths) {
  std::vector<Pin> pins;
  int first = 0;
  std::size_t grabs = 0;
  for (const ClothInput& cloth : cloths) {
    for (const PinInput& input : cloth.pins) {
      Pin pin{{}, grabs, input.from, input.until, input.motion, input.collider};
      for (const int v : input.vertices) pin.vertices.push_back(first + v);
      grabs += pin.vertices.size();
      pins.push_back(std::move(pin));
    }
    first += static_cast<int>(cloth.mesh.positions.size());
  }
  return pins;
}

std::vector<char> pinned_vertices(const std::vector<Pin>& pins, std::size_t count, double time) {
  std::vector<char> pinned(count, 0);
  for (const Pin& pin : pins)
    if (holds(pin, time))
      for (const int v : pin.vertices) pinned[v] = 1;
  return pinned;
}

void grab(const std::vector<Pin>& pins, double time, State& state) {
  for (const Pin& pin : pins) {
    state.grabs.resize(std::max(state.grabs.size(), pin.first_grab + pin.vertices.size()), Vec3::Zero());
    if (std::abs(time - pin.from) > same_time) continue;
    for (std::size_t i = 0; i < pin.vertices.size(); ++i) {
      const Vec3& point = state.positions[pin.vertices[i]];
      state.grabs[pin.first_grab + i] =
          pin.collider ? into_frame(state.collider_poses[*pin.collider], point) : point;
    }
  }
}

namespace {

// Calls visit(vertex, place at the start, place at the end) for all that the pin holds.
template <typename Visit>
void for_each_held(const Pin& pin, double begin, double end, const State& state,
                   std::span<const BodyMotion> colliders, const Visit& visit) {
  const auto grabs = std::span(state.grabs).subspan(pin.first_grab, pin.vertices.size());
  BodyMotion way;
  if (pin.collider)
    way = colliders[*pin.collider];
  else if (pin.motion)
    way = {way_since_grab(pin, begin, grabs), way_since_grab(pin, end, grabs)};
  const bool rests = !pin.motion && !pin.collider;
  for (std::size_t i = 0; i < grabs.size(); ++i)
    visit(pin.vertices[i], rests ? grabs[i] : way.start(grabs[i]), rests ? grabs[i] : way.end(grabs[i]));
}

// A pin that begins to hold at the end of a frame grabs only when the next one starts.
bool has_grabbed(const Pin& pin, double time) { return time > pin.from + same_time; }

}  // namespace

void place_pinned(const std::vector<Pin>& pins, double begin, double end, const State& state,
                  std::span<const BodyMotion> colliders, std::vector<Vec3>& x) {
  for (const Pin& pin : pins) {
    if (!holds(pin, begin)) continue;
    for_each_held(pin, begin, end, state, colliders, [&](int v, const Vec3& pin_start, const Vec3& pin_end) {
      x[v] = come_after(x[v], pin_start, pin_end, end - begin);
    });
  }
}

double largest_pin_lag(const std::vector<Pin>& pins, double time, const State& state) {
  std::vector<BodyMotion> colliders;
  for (const RigidPose& pose : state.collider_poses) colliders.push_back({pose, pose});
  double largest = 0;
  for (const Pin& pin : pins) {
    if (!holds(pin, time) || !has_grabbed(pin, time)) continue;
    for_each_held(pin, time, time, state, colliders, [&](int v, const Vec3& place, const Vec3&) {
      largest = std::max(largest, (state.positions[v] - place).norm());
    });
  }
  return largest;
}

}  // namespace drape
