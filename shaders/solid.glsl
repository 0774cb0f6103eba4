// Matte plastic: diffuse under a rough, thin gloss.
const float gloss_alpha = 0.3;
const float gloss_reflectance = 0.04;

float fifth_power(float x) { return x * x * x * x * x; }

// GGX with the height-correlated visibility of Heitz 2014 in Hammon's approximation (GDC 2017), and Schlick's
// Fresnel term.
float gloss(float n_l, float n_v, float n_h, float l_h) {
  float a2 = gloss_alpha * gloss_alpha;
  float spread = n_h * n_h * (a2 - 1.0) + 1.0;
  float distribution = a2 / (pi * spread * spread);
  float visible = 0.5 / mix(2.0 * n_l * n_v, n_l + n_v, gloss_alpha);
  float fresnel = gloss_reflectance + (1.0 - gloss_reflectance) * fifth_power(1.0 - l_h);
  return distribution * visible * fresnel;
}

vec3 scattered(vec3 albedo, vec3 normal, vec3 to_eye, vec3 to_light) {
  float n_l = max(dot(normal, to_light), 0.0);
  float n_v = clamp(dot(normal, to_eye), 0.02, 1.0);
  vec3 half_way = normalize(to_eye + to_light);
  float shine = gloss(n_l, n_v, max(dot(normal, half_way), 0.0), clamp(dot(to_light, half_way), 0.0, 1.0));
  return n_l * ((1.0 - gloss_reflectance) * albedo / pi + shine);
}
