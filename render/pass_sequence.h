#pragma once

#include <array>

#include "core/vector.h"

namespace drape::render {

// So many directions of light from all round each pass (a shadow map more costs far less than a pass more):
// the last comes from below the horizon, the others from the sky.
inline constexpr int sky_directions = 4;

// And so many places on the sun's disc.
inline constexpr int sun_places = 2;

struct SkySample {
  Vec3f direction;    // toward the light
  float solid_angle;  // that this direction stands for
};

// Where one pass of the accumulation takes its samples. The samples of all passes together are evenly spread
// in each of the dimensions; they are the same for every frame, so what stands still does not flicker.
struct PassSample {
  Vec2f pixel_offset;                      // from the centre, in pixels
  std::array<Vec2f, sun_places> sun_disc;  // in the unit disc
  std::array<SkySample, sky_directions> sky;
  float jitter_phase;  // of the noise that differs from pixel to pixel, in [0, 1)
};

PassSample sample_pass(int pass, int passes);

}  // namespace drape::render
