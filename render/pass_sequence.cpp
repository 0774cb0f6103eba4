#include "render/pass_sequence.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace drape::render {

static constexpr float two_pi = 2 * std::numbers::pi_v<float>;
static constexpr float golden_ratio = std::numbers::phi_v<float>;

static float fraction(float x) { return x - std::floor(x); }

// Another order of 0 ... count-1, so that two sequences of evenly spread points do not run along each other.
static int shuffled(int index, int count, float share) {
  int step = std::max(1, static_cast<int>(share * static_cast<float>(count)));
  while (std::gcd(step, count) != 1) ++step;
  return static_cast<int>((static_cast<long>(index) * step) % count);
}

// Fibonacci lattice in the unit square.
static Vec2f lattice(int index, int count) {
  const float i = static_cast<float>(index);
  return {(i + 0.5f) / static_cast<float>(count), fraction((i + 0.5f) * golden_ratio)};
}

// From uniform in [0, 1) to a tent on (-1, 1): as filter of the picture softer than a box, and calmer in
// motion.
static float tent(float x) { return x < 0.5f ? std::sqrt(2 * x) - 1 : 1 - std::sqrt(2 - 2 * x); }

// Vogel's spiral: `count` points that share the disc's area equally.
static Vec2f disc(const Vec2f& square) {
  const float radius = std::sqrt(square.x());
  return {radius * std::cos(two_pi * square.y()), radius * std::sin(two_pi * square.y())};
}

// Equal shares of the hemisphere's area (Archimedes: area goes with height).
static Vec3f hemisphere(const Vec2f& square) {
  const float radius = std::sqrt(1 - square.x() * square.x());
  return {radius * std::cos(two_pi * square.y()), square.x(), radius * std::sin(two_pi * square.y())};
}

static SkySample sample_sky(int index, int count) {
  return {hemisphere(lattice(index, count)), two_pi / static_cast<float>(count)};
}

static SkySample sample_below(int index, int count) {
  SkySample sample = sample_sky(index, count);
  sample.direction.y() *= -1;
  return sample;
}

PassSample sample_pass(int pass, int passes) {
  PassSample sample;
  const Vec2f pixel = lattice(shuffled(pass, passes, 0.382f), passes);
  sample.pixel_offset = {tent(pixel.x()), tent(pixel.y())};
  for (int i = 0; i < sun_places; ++i) {
    const int index = shuffled(pass * sun_places + i, passes * sun_places, 0.618f);
    sample.sun_disc[i] = disc(lattice(index, passes * sun_places));
  }
  const int upper = sky_directions - 1;
  for (int i = 0; i < upper; ++i) sample.sky[i] = sample_sky(pass * upper + i, passes * upper);
  sample.sky[upper] = sample_below(shuffled(pass, passes, 0.5f), passes);
  for (SkySample& sky : sample.sky) sky.solid_angle *= static_cast<float>(passes);
  sample.jitter_phase = fraction(static_cast<float>(pass) * golden_ratio);
  return sample;
}

}  // namespace drape::render
