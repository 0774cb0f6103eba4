#include "render/pass_uniforms.h"

#include <algorithm>
#include <cmath>

namespace drape::render {

Vec3f linear_from_srgb(const Color& color) {
  return color.unaryExpr(
      [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); });
}

static Vec4f extend(const Vec3f& xyz, float w) { return {xyz.x(), xyz.y(), xyz.z(), w}; }

// Radiance: the gradient above the horizon, what the ground throws back below it.
static Vec3f sky_radiance(const Sky& sky, const Vec3f& direction) {
  if (direction.y() < 0) return sky.intensity * linear_from_srgb(sky.ground);
  const float height = std::sqrt(direction.y());
  return sky.intensity * ((1 - height) * linear_from_srgb(sky.horizon) + height * linear_from_srgb(sky.top));
}

PassLights aim_lights(const View& view, const PassSample& sample, const Sphere& casters, int sun_map_size,
                      int sky_map_size) {
  const Vec3f to_sun = direction_to_sun(view.sun, sample.sun_disc);
  return {to_sun, fit_light(to_sun, casters, sun_map_size),
          fit_light(sample.sky_direction, casters, sky_map_size)};
}

PassUniforms pass_uniforms(const View& view, const Settings& settings, const Sphere& scene,
                           const PassSample& sample, const PassLights& lights) {
  const Camera& camera = view.camera;
  PassUniforms uniforms;
  uniforms.clip_from_world = camera_projection(view, settings, scene, sample.pixel_offset);
  uniforms.sun_map_from_world = lights.sun.map_from_world;
  uniforms.sky_map_from_world = lights.sky.map_from_world;
  uniforms.eye = extend(camera.eye, sample.jitter_phase);
  uniforms.sun_direction = extend(lights.to_sun, lights.sun.texel_size);
  uniforms.sun_irradiance = extend(view.sun.intensity * linear_from_srgb(view.sun.color), 0);
  uniforms.sky_direction = extend(sample.sky_direction, lights.sky.texel_size);
  uniforms.sky_irradiance = extend(sample.sky_solid_angle * sky_radiance(view.sky, sample.sky_direction), 0);
  uniforms.ground_fade = {camera.target.x(), view.ground.height, camera.target.z(),
                          ground_half_distance(camera)};
  return uniforms;
}

}  // namespace drape::render
