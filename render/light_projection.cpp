#include "render/light_projection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/axes.h"

namespace drape::render {

// Wide enough for the offset and the scatter of the taps (shaders/shadow.glsl).
static constexpr float border_texels = 9;

static Mat4f map_from_clip(int map_size) {
  const float half = 0.5f * static_cast<float>(map_size);
  Mat4f map = Mat4f::Identity();
  map.diagonal() = Vec4f(half, half, 0.5f, 1);
  map.col(3) = Vec4f(half, half, 0.5f, 1);
  return map;
}

LightProjection fit_light(const Vec3f& to_light, const Sphere& casters, int map_size) {
  const float radius = std::max(casters.radius, 1e-6f);
  const float texels = static_cast<float>(map_size);
  const float half_width = radius * texels / (texels - 2 * border_texels);
  const Axes axes = axes_along(to_light);
  LightProjection light;
  light.clip_from_world = Mat4f::Identity();
  light.clip_from_world.row(0).head<3>() = axes.right / half_width;
  light.clip_from_world.row(1).head<3>() = axes.up / half_width;
  light.clip_from_world.row(2).head<3>() = -axes.forward / half_width;
  light.clip_from_world.col(3).head<3>() = -light.clip_from_world.topLeftCorner<3, 3>() * casters.center;
  light.map_from_world = map_from_clip(map_size) * light.clip_from_world;
  light.texel_size = 2 * half_width / texels;
  return light;
}

Vec3f direction_to_sun(const Sun& sun, const Vec2f& place_on_disc) {
  const Axes axes = axes_along(-sun.direction);
  const float rim = std::tan(0.5f * sun.size * std::numbers::pi_v<float> / 180);
  const Vec3f direction = axes.forward + rim * (place_on_disc.x() * axes.right + place_on_disc.y() * axes.up);
  return direction.normalized();
}

}  // namespace drape::render
