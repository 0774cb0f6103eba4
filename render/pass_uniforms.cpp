#include "render/pass_uniforms.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::render {

Vec3f linear_from_srgb(const Color& color) {
  return color.unaryExpr(
      [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); });
}

static Vec4f extend(const Vec3f& xyz, float w) { return {xyz.x(), xyz.y(), xyz.z(), w}; }

static Vec3f sky_radiance(const Sky& sky, const Vec3f& direction) {
  const float height = std::sqrt(direction.y());
  return sky.intensity * ((1 - height) * linear_from_srgb(sky.horizon) + height * linear_from_srgb(sky.top));
}

static Vec3f sun_irradiance(const Sun& sun) { return sun.intensity * linear_from_srgb(sun.color); }

// What the ground throws back where the sun does not reach it. For a drawn ground: the mean of sky_radiance()
// over the cosine of the direction, of which a part is hidden by whoever receives this light.
static Vec3f shaded_ground_radiance(const View& view) {
  const Sky& sky = view.sky;
  if (!view.ground.visible) return sky.intensity * linear_from_srgb(sky.ground);
  const Vec3f mean = 0.2f * linear_from_srgb(sky.horizon) + 0.8f * linear_from_srgb(sky.top);
  const float not_hidden = 0.6f;
  return not_hidden * sky.intensity * mean.cwiseProduct(linear_from_srgb(view.ground.color));
}

static Vec3f sunlit_ground_radiance(const View& view) {
  if (!view.ground.visible) return Vec3f::Zero();
  const float cosine = std::max(0.0f, -view.sun.direction.normalized().y());
  const Vec3f irradiance = cosine * sun_irradiance(view.sun);
  return irradiance.cwiseProduct(linear_from_srgb(view.ground.color)) / std::numbers::pi_v<float>;
}

std::string pass_defines() {
  return "#define SKY_DIRECTIONS " + std::to_string(sky_directions) + "\n#define SUN_PLACES " +
         std::to_string(sun_places) + "\n";
}

PassLights aim_lights(const View& view, const PassSample& sample, const Sphere& casters, int sun_map_size,
                      int sky_map_size) {
  PassLights lights;
  for (int i = 0; i < sun_places; ++i) {
    lights.sun[i] = fit_light(direction_to_sun(view.sun, sample.sun_disc[i]), casters, sun_map_size);
  }
  for (int i = 0; i < sky_directions; ++i) {
    lights.sky[i] = fit_light(sample.sky[i].direction, casters, sky_map_size);
  }
  return lights;
}

PassUniforms pass_uniforms(const View& view, const Settings& settings, const Sphere& scene,
                           const PassSample& sample, const PassLights& lights) {
  const Camera& camera = view.camera;
  PassUniforms uniforms;
  uniforms.clip_from_world = camera_projection(view, settings, scene, sample.pixel_offset);
  uniforms.eye = extend(camera.eye, sample.jitter_phase);
  uniforms.sun_direction = extend(direction_to_sun(view.sun, sample.sun_disc[0]), lights.sun[0].texel_size);
  for (int i = 0; i < sun_places; ++i) uniforms.sun_map_from_world[i] = lights.sun[i].map_from_world;
  uniforms.sun_irradiance = extend(sun_irradiance(view.sun), 0);
  for (int i = 0; i < sky_directions; ++i) {
    const SkySample& sky = sample.sky[i];
    uniforms.sky_map_from_world[i] = lights.sky[i].map_from_world;
    uniforms.sky_direction[i] = extend(sky.direction, lights.sky[i].texel_size);
    uniforms.sky_radiance[i] = extend(sky_radiance(view.sky, sky.direction.cwiseAbs()), sky.solid_angle);
  }
  uniforms.ground_radiance = extend(shaded_ground_radiance(view), 0);
  uniforms.sunlit_ground_radiance = extend(sunlit_ground_radiance(view), 0);
  uniforms.ground_fade = {camera.target.x(), view.ground.height, camera.target.z(),
                          ground_half_distance(camera)};
  return uniforms;
}

}  // namespace drape::render
