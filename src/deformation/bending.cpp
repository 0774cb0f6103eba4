#include "deformation/bending.h"

#include <cmath>

#include "core/parallel.h"

namespace drape {

static double cotangent(const Vec3& corner, const Vec3& a, const Vec3& b) {
  const Vec3 u = a - corner, v = b - corner;
  return u.dot(v) / u.cross(v).norm();
}

// c_i of the edge (x0, x1) with x2 and x3 across: the cotangent weights of the unfolded pair.
static std::array<double, 4> affine_residual_weights(const Vec3& x0, const Vec3& x1, const Vec3& x2,
                                                     const Vec3& x3) {
  const double at0_2 = cotangent(x0, x1, x2), at0_3 = cotangent(x0, x1, x3);
  const double at1_2 = cotangent(x1, x0, x2), at1_3 = cotangent(x1, x0, x3);
  return {at1_2 + at1_3, at0_2 + at0_3, -at0_2 - at1_2, -at0_3 - at1_3};
}

static Vec3 residual(const Hinge& hinge, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 4; ++i) sum += hinge.weights[i] * x[hinge.vertices[i]];
  return sum;
}

static Hinge build_hinge(const Sheet& sheet, const Edge& edge) {
  const auto across = [&](int triangle) {
    for (const int vertex : sheet.triangles[triangle])
      if (vertex != edge.vertices[0] && vertex != edge.vertices[1]) return vertex;
    return -1;
  };
  Hinge hinge{};
  hinge.vertices = {edge.vertices[0], edge.vertices[1], across(edge.triangles[0]), across(edge.triangles[1])};
  const std::vector<Vec3>& x = sheet.rest_positions;
  const auto& [a, b, c, d] = hinge.vertices;
  hinge.weights = affine_residual_weights(x[a], x[b], x[c], x[d]);
  const double flat = 1e-9 * (x[b] - x[a]).norm();
  hinge.rest_residual = residual(hinge, x).norm();
  if (hinge.rest_residual < flat) hinge.rest_residual = 0;
  const ElasticMaterial& material = sheet.materials[sheet.triangle_materials[edge.triangles[0]]];
  const double area = rest_area(sheet, edge.triangles[0]) + rest_area(sheet, edge.triangles[1]);
  hinge.stiffness = 3 * material.bend_stiffness / area;
  hinge.damping = material.damping;
  return hinge;
}

HingeStage build_hinges(const Sheet& sheet) {
  std::vector<Hinge> hinges;
  std::vector<std::array<int, 4>> vertices;
  for (const Edge& edge : sheet.topology.edges) {
    if (edge.triangles[1] < 0) continue;
    hinges.push_back(build_hinge(sheet, edge));
    vertices.push_back(hinges.back().vertices);
  }
  Coloring coloring = color_elements(static_cast<int>(sheet.rest_positions.size()), vertices);
  HingeStage stage{{}, std::move(coloring.color_begin)};
  for (const int i : coloring.order) stage.hinges.push_back(hinges[i]);
  return stage;
}

template <typename Body>
static void for_each_hinge(const HingeStage& stage, const Body& body) {
  constexpr std::size_t block = 256;
  for (std::size_t color = 0; color + 1 < stage.color_begin.size(); ++color) {
    const std::size_t begin = stage.color_begin[color];
    parallel_for_each(stage.color_begin[color + 1] - begin, block,
                      [&](std::size_t i) { body(stage.hinges[begin + i]); });
  }
}

// sum of w_i c_i2: the residual's answer to a unit pull.
static double compliance_of_points(const Hinge& hinge, const std::vector<double>& inverse_masses) {
  double sum = 0;
  for (int i = 0; i < 4; ++i) sum += inverse_masses[hinge.vertices[i]] * hinge.weights[i] * hinge.weights[i];
  return sum;
}

static void push_residual(const Hinge& hinge, const std::vector<double>& inverse_masses, const Vec3& pull,
                          std::vector<Vec3>& x) {
  for (int i = 0; i < 4; ++i)
    x[hinge.vertices[i]] -= inverse_masses[hinge.vertices[i]] * hinge.weights[i] * pull;
}

void pull_hinges(const HingeStage& stage, const std::vector<double>& inverse_masses, double step,
                 std::vector<Vec3>& x) {
  for_each_hinge(stage, [&](const Hinge& hinge) {
    const double response = compliance_of_points(hinge, inverse_masses);
    if (!(response > 0) || !(hinge.stiffness > 0)) return;
    const Vec3 r = residual(hinge, x);
    const double length = r.norm();
    if (!(length > 0)) return;
    const Vec3 excess = r * (1 - hinge.rest_residual / length);
    push_residual(hinge, inverse_masses, excess / (response + 1 / (hinge.stiffness * step * step)), x);
  });
}

void damp_bending(const HingeStage& stage, const std::vector<double>& inverse_masses, double step,
                  std::vector<Vec3>& velocities) {
  for_each_hinge(stage, [&](const Hinge& hinge) {
    const double response = compliance_of_points(hinge, inverse_masses);
    if (!(response > 0) || !(hinge.damping > 0)) return;
    const double share = hinge.damping * step / (1 + hinge.damping * step);
    push_residual(hinge, inverse_masses, share / response * residual(hinge, velocities), velocities);
  });
}

}  // namespace drape
