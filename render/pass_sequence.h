#pragma once

#include "core/vector.h"

namespace drape::render {

// Where one pass of the accumulation takes its samples. The samples of all passes together are evenly spread
// in each of the dimensions; they are the same for every frame, so what stands still does not flicker.
struct PassSample {
  Vec2f pixel_offset;     // from the centre, in pixels
  Vec2f sun_disc;         // in the unit disc
  Vec3f sky_direction;    // toward the light
  float sky_solid_angle;  // that this direction stands for, were it the only pass
  float jitter_phase;     // of the noise that differs from pixel to pixel, in [0, 1)
};

// One pass in five lies below the horizon (light that the ground throws back), and at least one of two or
// more.
PassSample sample_pass(int pass, int passes);

}  // namespace drape::render
