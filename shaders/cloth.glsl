uniform float sheen;
uniform float translucency;

const float wrap = 0.08;
// Charlie: the distribution of fibres that stand out of the cloth (Estevez and Kulla, "Production Friendly
// Microfacet Sheen BRDF", 2017, equation 2) with the visibility term of Neubelt and Pettineo ("Crafting a
// Next-Gen Material Pipeline for The Order: 1886", 2013). At a roughness of 0.5 the exponent of the sine is 2, and
// the half vector's cosine is needed only squared: no root and no power.
float charlie(float n_l, float n_v, float l_v) {
  float n_h_squared = (n_l + n_v) * (n_l + n_v) / (2.0 + 2.0 * l_v + 1e-4);
  float distribution = 4.0 * max(1.0 - n_h_squared, 0.0) / (2.0 * pi);
  return distribution / (4.0 * (n_l + n_v - n_l * n_v));
}

// The share of light from one direction that the fibres scatter: a fit to the integral of charlie(), within 0.03.
float charlie_albedo(float cosine) { return 0.11 + 0.57 * (1.0 - cosine) * (1.0 - cosine); }

vec3 sheen_color(vec3 albedo) {
  vec3 hue = albedo / max(max(albedo.r, albedo.g), max(albedo.b, 1e-3));
  return sheen * mix(vec3(1.0), hue, 0.75);
}

// Light that the cloth throws back: diffuse, softened round the terminator by loose fibres, and sheen; what the
// sheen takes is missing from the diffuse part.
vec3 reflected(vec3 albedo, vec3 normal, vec3 to_eye, vec3 to_light) {
  float n_l = dot(normal, to_light);
  float lit = max(n_l, 0.0);
  float n_v = clamp(dot(normal, to_eye), 0.02, 1.0);
  float diffuse = max(n_l + wrap, 0.0) / ((1.0 + wrap) * (1.0 + wrap) * pi);
  float kept = 1.0 - sheen * max(charlie_albedo(n_v), charlie_albedo(lit));
  float fibres = lit * charlie(lit, n_v, dot(to_light, to_eye));
  return (1.0 - translucency) * kept * diffuse * albedo + fibres * sheen_color(albedo);
}

vec3 transmitted(vec3 albedo, vec3 normal, vec3 to_light) {
  return translucency * albedo * max(-dot(normal, to_light), 0.0) / pi;
}

vec3 scattered(vec3 albedo, vec3 normal, vec3 to_eye, vec3 to_light) {
  return reflected(albedo, normal, to_eye, to_light) + transmitted(albedo, normal, to_light);
}
