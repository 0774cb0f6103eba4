uniform sampler2D sun_map;
uniform sampler2D sky_map;  // a tile for each direction, in a row

// A texel and a half keeps a surface from shading itself between the samples of the map.
const float normal_offset = 1.5;
// How far, in texels, the one tap is scattered over the tangent plane: over the passes this is the filter.
const float scatter_radius = 2.0;

// A vector in the unit sphere, another one for each pixel and pass.
vec3 pixel_scatter() {
  float turn = 2.0 * pi * fract(gradient_noise(gl_FragCoord.xy) + eye.w);
  float radius = sqrt(fract(gradient_noise(gl_FragCoord.yx + 17.0) + 1.618034 * eye.w));
  return radius * vec3(cos(turn), sin(turn), sin(2.0 * turn));
}

// 1 where the light reaches `position`, 0 where something is before it. `side` is the normal on the lit side.
// The border of each square of the map is empty, so what lies outside is lit.
float visibility(sampler2D map, int tile, mat4 map_from_world, vec3 position, vec3 side, vec3 scatter, float texel) {
  vec3 along_surface = scatter - side * dot(side, scatter);
  vec3 receiver = position + texel * (normal_offset * side + scatter_radius * along_surface);
  vec3 at = (map_from_world * vec4(receiver, 1.0)).xyz;
  int size = textureSize(map, 0).y;
  ivec2 place = clamp(ivec2(at.xy), ivec2(0), ivec2(size - 1)) + ivec2(tile * size, 0);
  float blocker = texelFetch(map, place, 0).r;
  return min(at.z, 1.0) <= blocker ? 1.0 : 0.0;
}

float sun_visibility(vec3 position, vec3 side, vec3 scatter) {
  return visibility(sun_map, 0, sun_map_from_world, position, side, scatter, sun_direction.w);
}

float sky_visibility(int i, vec3 position, vec3 side, vec3 scatter) {
  return visibility(sky_map, i, sky_map_from_world[i], position, side, scatter, sky_direction[i].w);
}

// The light that comes up from the point of the ground that is seen from `position` along the direction below.
vec3 radiance_from_below(vec3 position) {
  vec3 down = sky_direction[below].xyz;
  float distance = max(position.y - ground_fade.y, 0.0) / max(-down.y, 0.05);
  float sunlit = visibility(sun_map, 0, sun_map_from_world, position + distance * down, vec3(0.0), vec3(0.0), 0.0);
  return ground_radiance.rgb + sunlit * sunlit_ground_radiance.rgb;
}

// What blocks the sky reflects light itself, mostly in the colour of the surface it shades (the other flank of a
// fold): the part of the sky's light that still arrives, by colour. A stand-in for the light's further bounces.
vec3 sky_share(float visible, vec3 albedo) { return mix(0.5 * albedo, vec3(1.0), visible); }
