// What one pass of the accumulation shares between all shaders; render/pass_uniforms.h lays out the same.
layout(std140) uniform Pass {
  mat4 clip_from_world;
  mat4 sun_map_from_world[SUN_PLACES];  // x and y in texels of the map, z in [0, 1]
  mat4 sky_map_from_world[SKY_DIRECTIONS];
  vec4 eye;              // w: the phase of the pixels' jitter
  vec4 sun_direction;    // toward its first place; w: the size of a texel in metres
  vec4 sun_irradiance;
  vec4 sky_direction[SKY_DIRECTIONS];   // toward the light; w: the size of a texel in metres
  vec4 sky_radiance[SKY_DIRECTIONS];    // w: the solid angle that the direction stands for
  vec4 ground_radiance;         // where the sun does not reach the ground
  vec4 sunlit_ground_radiance;  // what is added where it does
  vec4 ground_fade;      // x, z: the centre; y: the height; w: the distance at which the ground is half gone
};

// The last direction points below the horizon.
const int below = SKY_DIRECTIONS - 1;

const float pi = 3.14159265;
