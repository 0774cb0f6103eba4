// A tile for each place on the sun and for each direction of the sky, in a row.
uniform sampler2D sun_map;
uniform sampler2D sky_map;

// A texel and a half keeps a surface from shading itself between the samples of the map.
const float normal_offset = 1.5;
// How far, in texels, a tap is scattered over the tangent plane: over the passes this is the filter. The sky's
// shadows are meant to be soft.
const float sun_scatter = 2.0;
const float sky_scatter = 6.0;

// A vector in the unit sphere, another one for each pixel and pass.
vec3 pixel_scatter() {
  float turn = 2.0 * pi * fract(gradient_noise(gl_FragCoord.xy) + eye.w);
  float radius = sqrt(fract(gradient_noise(gl_FragCoord.yx + 17.0) + 1.618034 * eye.w));
  vec2 round = vec2(cos(turn), sin(turn));
  return radius * vec3(round, 2.0 * round.x * round.y);
}

// 1 where the light reaches `position`, 0 where something is before it. `side` is the normal on the lit
// side, `scatter` in texels.
// The border of each square of the map is empty, so what lies outside is lit.
float visibility(sampler2D map, int tile, mat4 map_from_world, vec3 position, vec3 side, vec3 scatter, float texel) {
  vec3 along_surface = scatter - side * dot(side, scatter);
  vec3 receiver = position + texel * (normal_offset * side + along_surface);
  vec3 at = (map_from_world * vec4(receiver, 1.0)).xyz;
  int size = textureSize(map, 0).y;
  ivec2 place = clamp(ivec2(at.xy), ivec2(0), ivec2(size - 1)) + ivec2(tile * size, 0);
  float blocker = texelFetch(map, place, 0).r;
  return min(at.z, 1.0) <= blocker ? 1.0 : 0.0;
}

float sun_visibility(vec3 position, vec3 side, vec3 scatter) {
  float sum = 0.0;
  for (int i = 0; i < SUN_PLACES; ++i) {
    sum += visibility(sun_map, i, sun_map_from_world[i], position, side, sun_scatter * scatter, sun_direction.w);
  }
  return sum / float(SUN_PLACES);
}

float sky_visibility(int i, vec3 position, vec3 side, vec3 scatter) {
  return visibility(sky_map, i, sky_map_from_world[i], position, side, sky_scatter * scatter, sky_direction[i].w);
}

// How far the pixels spread round the direction below, over the way to the ground: without, the few directions draw
// the sun's shadow on the ground, edge by edge, onto what it lights.
const float spread_below = 0.35;

// The share of the ground round `place` that the sun reaches: four taps, a quarter turn of `scatter` apart.
float sunlit_share(vec3 place, vec2 scatter) {
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    sum += visibility(sun_map, 0, sun_map_from_world[0], place + vec3(scatter.x, 0.0, scatter.y), vec3(0.0),
                      vec3(0.0), 0.0);
    scatter = vec2(-scatter.y, scatter.x);
  }
  return 0.25 * sum;
}

// The light that comes up from the ground that is seen from `position` round the direction below.
vec3 radiance_from_below(vec3 position, vec3 scatter) {
  vec3 down = sky_direction[below].xyz;
  float distance = max(position.y - ground_fade.y, 0.0) / max(-down.y, 0.05);
  float sunlit = sunlit_share(position + distance * down, distance * spread_below * scatter.xy);
  return ground_radiance.rgb + sunlit * sunlit_ground_radiance.rgb;
}

// What blocks the sky reflects light itself, mostly in the colour of the surface it shades (the other flank of a
// fold): the part of the sky's light that still arrives, by colour. A stand-in for the light's further bounces.
vec3 sky_share(float visible, vec3 albedo) { return mix(0.5 * albedo, vec3(1.0), visible); }
