in vec3 world_position;
in vec3 world_normal;
in vec2 surface_uv;

layout(location = 0) out vec4 radiance;

// The normal of the side that a light falls on: where that is the far side, it is its own shadow that counts.
vec3 lit_side(vec3 normal, vec3 to_light) { return dot(normal, to_light) < 0.0 ? -normal : normal; }

vec3 from_sun(vec3 albedo, vec3 normal, vec3 to_eye, vec3 scatter) {
  float visible = sun_visibility(world_position, lit_side(normal, sun_direction.xyz), scatter);
  return visible * sun_irradiance.rgb * scattered(albedo, normal, to_eye, sun_direction.xyz);
}

vec3 from_sky(int i, vec3 sky, vec3 albedo, vec3 normal, vec3 to_eye, vec3 scatter) {
  float visible = sky_visibility(i, world_position, lit_side(normal, sky_direction[i].xyz), scatter);
  return sky_share(visible, albedo) * sky_radiance[i].w * sky *
         scattered(albedo, normal, to_eye, sky_direction[i].xyz);
}

void main() {
  vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);
  vec3 to_eye = normalize(eye.xyz - world_position);
  vec3 albedo = surface_albedo(surface_uv, gl_FrontFacing);
  vec3 scatter = pixel_scatter();
  vec3 sum = from_sun(albedo, normal, to_eye, scatter);
  for (int i = 0; i < below; ++i) sum += from_sky(i, sky_radiance[i].rgb, albedo, normal, to_eye, scatter);
  sum += from_sky(below, radiance_from_below(world_position, scatter), albedo, normal, to_eye, scatter);
  radiance = vec4(sum, 1.0);
}
