#include "simulation/wind.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace drape {
namespace {

// The finalizer of splitmix64 (Steele et al. 2014, Fast Splittable Pseudorandom Number Generators): each bit
// of the result depends on each of the value.
std::uint64_t mix(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
  value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
  return value ^ (value >> 31);
}

// A random vector in [-1, 1) along each axis, of one point of the lattice.
Vec3 lattice_vector(std::uint64_t seed, const std::array<std::int64_t, 3>& point) {
  std::uint64_t hash = seed;
  for (const std::int64_t coordinate : point) hash = mix(hash ^ static_cast<std::uint64_t>(coordinate));
  constexpr std::uint64_t low_bits = (1 << 21) - 1;
  const auto part = [&](int shift) {
    return static_cast<double>((hash >> shift) & low_bits) / (1 << 20) - 1;
  };
  return {part(0), part(21), part(42)};
}

// Perlin's quintic blend (Perlin 2002, Improving Noise): its first two derivatives vanish at 0 and 1.
double blend(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

// Value noise: random vectors on the unit lattice, blended between its points.
Vec3 noise(std::uint64_t seed, const Vec3& place) {
  std::array<std::int64_t, 3> cell{};
  std::array<double, 3> upper{};
  for (int axis = 0; axis < 3; ++axis) {
    const double floor = std::floor(place[axis]);
    cell[axis] = static_cast<std::int64_t>(floor);
    upper[axis] = blend(place[axis] - floor);
  }
  Vec3 sum = Vec3::Zero();
  for (int corner = 0; corner < 8; ++corner) {
    std::array<std::int64_t, 3> point = cell;
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_upper = (corner >> axis) & 1;
      point[axis] += is_upper;
      weight *= is_upper ? upper[axis] : 1 - upper[axis];
    }
    sum += weight * lattice_vector(seed, point);
  }
  return sum;
}

}  // namespace

// m/s: by how much gusts depart from the mean along each axis.
static double gust_speed(const WindInput& wind) { return wind.gust * wind.velocity.norm(); }

bool has_air(const WindInput& wind) { return wind.drag > 0 || wind.tangential_drag > 0; }

bool is_steady(const WindInput& wind) { return !(gust_speed(wind) > 0); }

Vec3 wind_at(const WindInput& wind, const Vec3& place, double time) {
  const double speed = gust_speed(wind);
  if (!(speed > 0)) return wind.velocity;
  const Vec3 carried = (place - time * wind.velocity) / wind.gust_size;
  const std::uint64_t seed = mix(static_cast<std::uint64_t>(wind.seed));
  // Whirls of three sizes hold less speed the smaller they are; the three shares add up to one.
  const Vec3 pattern = 4.0 / 7 * noise(seed, carried) + 2.0 / 7 * noise(seed + 1, 2 * carried) +
                       1.0 / 7 * noise(seed + 2, 4 * carried);
  return wind.velocity + speed * pattern;
}

}  // namespace drape
