#pragma once

#include "core/vector.h"
#include "render/projection.h"

namespace drape::render {

// A shadow map's parallel projection along a direction of light.
struct LightProjection {
  Mat4f clip_from_world;  // to draw the map
  Mat4f map_from_world;   // to look it up: x and y in texels, z in [0, 1]
  float texel_size = 0;   // in the world
};

// The sphere fills the map but for a border, which stays empty: whoever looks beyond it finds no shadow.
LightProjection fit_light(const Vec3f& to_light, const Sphere& casters, int map_size);

// The direction to a point on the sun's disc: (0, 0) is its middle, length 1 its rim.
Vec3f direction_to_sun(const Sun& sun, const Vec2f& place_on_disc);

}  // namespace drape::render
