// Woven patterns as functions of the texture coordinates, averaged over the pixel: the integral of the pattern
// over the pixel's footprint, taken as a box along u and v, divided by the box. Nothing flickers in the distance.

uniform vec3 color;   // linear, of the side that is seen, the front
uniform vec3 back;
uniform vec3 accent;
uniform float pattern_scale;

// The integral from 0 to x of the wave that is 1 on [from, to) of each unit interval and 0 elsewhere.
float band_integral(float x, float from, float to) {
  return floor(x) * (to - from) + clamp(fract(x) - from, 0.0, to - from);
}

float band(float x, float width, float from, float to) {
  return (band_integral(x + 0.5 * width, from, to) - band_integral(x - 0.5 * width, from, to)) / width;
}

#if PATTERN == PATTERN_CHECKER
vec3 pattern(vec3 base, vec2 x, vec2 width) {
  float a = band(x.x, width.x, 0.0, 0.5);
  float b = band(x.y, width.y, 0.0, 0.5);
  return mix(base, accent, a + b - 2.0 * a * b);
}
#elif PATTERN == PATTERN_STRIPE
// The seam of a repeat lies within a band: else a hem, half a pixel of which lies beyond it, would be edged.
vec3 pattern(vec3 base, vec2 x, vec2 width) { return mix(base, accent, band(x.x, width.x, 0.25, 0.75)); }
#elif PATTERN == PATTERN_TARTAN
// One set of threads: a broad dark band with a fine light line along each edge and a finer one in its middle.
vec3 threads(vec3 base, float x, float width) {
  vec3 shade = mix(base, 0.18 * base, band(x, width, 0.28, 0.72));
  float lines = band(x, width, 0.32, 0.35) + band(x, width, 0.65, 0.68) + band(x, width, 0.49, 0.51);
  return mix(shade, accent, lines);
}

// Warp and weft lie over each other by turns too fine to see: half of each.
vec3 pattern(vec3 base, vec2 x, vec2 width) {
  return 0.5 * (threads(base, x.x, width.x) + threads(base, x.y, width.y));
}
#else
vec3 pattern(vec3 base, vec2 x, vec2 width) { return base; }
#endif

vec3 surface_albedo(vec2 uv, bool front) {
  vec2 x = pattern_scale * uv;
  return pattern(front ? color : back, x, max(fwidth(x), vec2(1e-4)));
}
