#include "core/rigid_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace drape {

double sample(const Track& track, double time) {
  if (track.empty()) return 0;
  const auto next = std::upper_bound(track.begin(), track.end(), time,
                                     [](double t, const auto& key) { return t < key.first; });
  if (next == track.begin()) return track.front().second;
  if (next == track.end()) return track.back().second;
  const auto [t0, v0] = *(next - 1);
  const auto [t1, v1] = *next;
  return v0 + (v1 - v0) * ((time - t0) / (t1 - t0));
}

// Taylor polynomials on [-pi/4, pi/4]: the first term left out is under 2e-17 there.
static double sin_near_zero(double x) {
  const double s = x * x;
  double sum = 1.0 / 355687428096000.0;
  for (const double denominator : {1307674368000.0, 6227020800.0, 39916800.0, 362880.0, 5040.0, 120.0, 6.0})
    sum = 1.0 / denominator - s * sum;
  return x - x * s * sum;
}

static double cos_near_zero(double x) {
  const double s = x * x;
  double sum = 1.0 / 6402373705728000.0;
  for (const double denominator :
       {20922789888000.0, 87178291200.0, 479001600.0, 3628800.0, 40320.0, 720.0, 24.0, 2.0})
    sum = 1.0 / denominator - s * sum;
  return 1.0 - s * sum;
}

std::pair<double, double> sin_cos_degrees(double degrees) {
  const double quarter_turns = std::nearbyint(degrees / 90.0);
  const double rest = (degrees - 90.0 * quarter_turns) * (std::numbers::pi / 180.0);
  const double s = sin_near_zero(rest);
  const double c = cos_near_zero(rest);
  switch (static_cast<long long>(quarter_turns) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

Mat3 rotation_from_degrees(const Vec3& degrees) {
  const auto [sx, cx] = sin_cos_degrees(degrees.x());
  const auto [sy, cy] = sin_cos_degrees(degrees.y());
  const auto [sz, cz] = sin_cos_degrees(degrees.z());
  Mat3 x, y, z;
  x << 1, 0, 0, 0, cx, -sx, 0, sx, cx;
  y << cy, 0, sy, 0, 1, 0, -sy, 0, cy;
  z << cz, -sz, 0, sz, cz, 0, 0, 0, 1;
  return z * y * x;
}

RigidPose pose_at(const RigidMotion& motion, double time) {
  const auto sampled = [&](const Track(&tracks)[3]) {
    return Vec3(sample(tracks[0], time), sample(tracks[1], time), sample(tracks[2], time));
  };
  return {rotation_from_degrees(sampled(motion.turn)) * rotation_from_degrees(motion.rotate),
          motion.at + sampled(motion.translate)};
}

bool is_static(const RigidMotion& motion) {
  const auto moves = [](const Track& track) { return track.size() > 1; };
  return std::none_of(std::begin(motion.translate), std::end(motion.translate), moves) &&
         std::none_of(std::begin(motion.turn), std::end(motion.turn), moves);
}

static bool changes_between(const Track& track, double begin, double end) {
  const double value = sample(track, begin);
  return sample(track, end) != value || std::any_of(track.begin(), track.end(), [&](const auto& key) {
           return key.first > begin && key.first < end && key.second != value;
         });
}

bool moves_between(const RigidMotion& motion, double begin, double end) {
  for (const auto* tracks : {&motion.translate, &motion.turn})
    for (const Track& track : *tracks)
      if (changes_between(track, begin, end)) return true;
  return false;
}

static double steepest(const Track& track) {
  double steepest = 0;
  for (std::size_t i = 1; i < track.size(); ++i)
    steepest = std::max(
        steepest, std::abs((track[i].second - track[i - 1].second) / (track[i].first - track[i - 1].first)));
  return steepest;
}

double largest_speed(const RigidMotion& motion) {
  return Vec3(steepest(motion.translate[0]), steepest(motion.translate[1]), steepest(motion.translate[2]))
      .norm();
}

static double next_key(const Track& track, double time) {
  const auto next = std::upper_bound(track.begin(), track.end(), time + 1e-9,
                                     [](double t, const auto& key) { return t < key.first; });
  return next == track.end() ? std::numeric_limits<double>::infinity() : next->first;
}

double next_key(const RigidMotion& motion, double time) {
  double next = std::numeric_limits<double>::infinity();
  for (const auto* tracks : {&motion.translate, &motion.turn})
    for (const Track& track : *tracks) next = std::min(next, next_key(track, time));
  return next;
}

}  // namespace drape
