in vec3 world_position;

layout(location = 0) out vec4 radiance;

uniform vec3 color;  // linear

const vec3 up = vec3(0.0, 1.0, 0.0);

// The share of the ground that is left at this place; the rest is the backdrop.
float share_left() {
  float distance_share = length(world_position.xz - ground_fade.xz) / ground_fade.w;
  return exp2(-distance_share * distance_share);
}

vec3 from_sky(int i, vec3 scatter) {
  vec3 share = sky_share(sky_visibility(i, world_position, up, scatter), color);
  return share * sky_radiance[i].w * sky_radiance[i].rgb * max(sky_direction[i].y, 0.0);
}

void main() {
  vec3 scatter = pixel_scatter();
  vec3 sun = sun_irradiance.rgb * max(sun_direction.y, 0.0) * sun_visibility(world_position, up, scatter);
  vec3 sky = vec3(0.0);
  for (int i = 0; i < below; ++i) sky += from_sky(i, scatter);
  radiance = vec4(color / pi * (sun + sky), 1.0) * share_left();
}
