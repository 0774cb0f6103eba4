#pragma once

#include <utility>
#include <vector>

#include "core/vector.h"

namespace drape {

// A rotation followed by a translation: p -> rotation p + translation.
struct RigidPose {
  Mat3 rotation = Mat3::Identity();
  Vec3 translation = Vec3::Zero();
  Vec3 operator()(const Vec3& point) const { return rotation * point + translation; }
};

// (time in seconds, value), times strictly increasing. Linear between keys, constant outside them; empty is
// 0.
using Track = std::vector<std::pair<double, double>>;
double sample(const Track& track, double time);

// A placement, and what keyframes add to it. Rotations are in degrees, about x, then y, then z, and about the
// body's own origin (Tait-Bryan, fixed axes).
struct RigidMotion {
  Vec3 at = Vec3::Zero();
  Vec3 rotate = Vec3::Zero();
  Track translate[3];
  Track turn[3];
};
RigidPose pose_at(const RigidMotion& motion, double time);
bool is_static(const RigidMotion& motion);

// Whether its poses in that time (s) differ.
bool moves_between(const RigidMotion& motion, double begin, double end);

// m/s: no point of the body that does not turn is faster than this between keys.
double largest_speed(const RigidMotion& motion);

// The time of the first key after `time`, by more than a nanosecond; infinity where there is none. Up to it
// the motion is even.
double next_key(const RigidMotion& motion, double time);

// sin and cos of an angle in degrees with the same bits on every machine (libm's differ in the last bit).
std::pair<double, double> sin_cos_degrees(double degrees);

Mat3 rotation_from_degrees(const Vec3& degrees);

}  // namespace drape
