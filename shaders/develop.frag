// From the sum of the passes to what a screen shows.

uniform sampler2D picture;
uniform float exposure;
uniform float share_of_pass;  // one over the number of passes
uniform vec3 backdrop;   // linear, as it shall be seen

layout(location = 0) out vec4 display;

// After AgX (Sobotka 2022): colours drawn a little toward grey, so that strong light bleaches them; a sigmoid
// over the logarithm of each channel; then drawn apart again.
const float inset = 0.14;
const float outset = 0.06;
const float stops_below_grey = 10.0;
const float stops_above_grey = 3.2;
const float grey = 0.18;
const float grey_shown = 0.46;  // 0.18 in the sRGB encoding
const float slope = 2.6;
const vec3 luminance_weights = vec3(0.2126, 0.7152, 0.0722);

// A sigmoid through (pivot, grey_shown) with `slope` there; `reach` and `rise` are the distances from the pivot
// to where the curve ends. Its power p is chosen by the caller.
float branch(float x, float reach, float rise, float power) {
  float end = slope * reach / rise;
  float limit = slope * reach / pow(pow(end, power) - 1.0, 1.0 / power);
  return slope * x / pow(1.0 + pow(slope * x / limit, power), 1.0 / power);
}

float sigmoid(float x) {
  float pivot = stops_below_grey / (stops_below_grey + stops_above_grey);
  if (x >= pivot) return grey_shown + branch(x - pivot, 1.0 - pivot, 1.0 - grey_shown, 1.5);
  return grey_shown - branch(pivot - x, pivot, grey_shown, 1.5);
}

float shown(float light) {
  float stops = clamp(log2(max(light, 1e-10) / grey), -stops_below_grey, stops_above_grey);
  return sigmoid((stops + stops_below_grey) / (stops_below_grey + stops_above_grey));
}

vec3 toward_grey(vec3 color, float amount) { return mix(color, vec3(dot(color, luminance_weights)), amount); }

vec3 linear_from_srgb(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }

vec3 srgb_from_linear(vec3 c) {
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

vec3 tone_mapped(vec3 light) {
  vec3 soft = toward_grey(light, inset);
  vec3 encoded = vec3(shown(soft.r), shown(soft.g), shown(soft.b));
  return clamp(toward_grey(linear_from_srgb(encoded), -outset), 0.0, 1.0);
}

// At an exposure of 1, a white wall in the light that View has by default is shown just below white.
const float exposure_of_one = 0.58;

void main() {
  vec4 sum = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
  vec3 seen = tone_mapped(exposure_of_one * exposure * sum.rgb / max(sum.a, 1e-6));
  vec3 composed = mix(backdrop, seen, clamp(sum.a * share_of_pass, 0.0, 1.0));
  float half_step = (gradient_noise(gl_FragCoord.xy) - 0.5) / 255.0;
  display = vec4(srgb_from_linear(composed) + half_step, 1.0);
}
