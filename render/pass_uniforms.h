#pragma once

#include <array>
#include <string>

#include "core/vector.h"
#include "render/light_projection.h"
#include "render/pass_sequence.h"

namespace drape::render {

// The memory of the uniform block of shaders/pass.glsl (std140: only vectors and matrices of four).
struct PassUniforms {
  Mat4f clip_from_world;
  std::array<Mat4f, sun_places> sun_map_from_world;
  std::array<Mat4f, sky_directions> sky_map_from_world;
  Vec4f eye;
  Vec4f sun_direction;
  Vec4f sun_irradiance;
  std::array<Vec4f, sky_directions> sky_direction;
  std::array<Vec4f, sky_directions> sky_radiance;
  Vec4f ground_radiance;
  Vec4f sunlit_ground_radiance;
  Vec4f ground_fade;
};

// The lights of a pass and how their maps look at the scene.
struct PassLights {
  std::array<LightProjection, sun_places> sun;
  std::array<LightProjection, sky_directions> sky;
};

PassLights aim_lights(const View& view, const PassSample& sample, const Sphere& casters, int sun_map_size,
                      int sky_map_size);

PassUniforms pass_uniforms(const View& view, const Settings& settings, const Sphere& scene,
                           const PassSample& sample, const PassLights& lights);

// The constants that shaders/pass.glsl wants.
std::string pass_defines();

Vec3f linear_from_srgb(const Color& color);

}  // namespace drape::render
