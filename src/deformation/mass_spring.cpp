#include "deformation/mass_spring.h"

#include <cmath>

#include "deformation/bending_angle.h"

namespace drape {

// What the elements read of a triangle's material: tension per width over strain in N/m, flexural rigidity in
// N m, and the rate at which a rate of stretch or bending dies out in 1/s.
static double membrane_stiffness(const Sheet& sheet, int triangle) {
  return sheet.materials[sheet.triangle_materials[triangle]].stretch_stiffness;
}

static double flexural_rigidity(const Sheet& sheet, int triangle) {
  return sheet.materials[sheet.triangle_materials[triangle]].bend_stiffness;
}

static double damping_rate(const Sheet& sheet, int triangle) {
  return sheet.materials[sheet.triangle_materials[triangle]].damping;
}

// The damping b of an element with gradients g_i for which its rate, alone, dies out as e^(-d t): b sum w_i
// |g_i|2 = d. Zero where all of its points are pinned.
template <std::size_t N>
static double element_damping(double rate, const std::array<int, N>& vertices,
                              const std::array<Vec3, N>& gradients,
                              const std::vector<double>& inverse_masses) {
  double response = 0;
  for (std::size_t i = 0; i < N; ++i) response += inverse_masses[vertices[i]] * gradients[i].squaredNorm();
  return response > 0 ? rate / response : 0;
}

static Spring build_spring(const Sheet& sheet, const Edge& edge, const std::vector<double>& inverse_masses) {
  const auto& [a, b] = edge.vertices;
  const Vec3 along = sheet.rest_positions[b] - sheet.rest_positions[a];
  Spring spring{edge.vertices, along.norm(), 0, 0};
  for (const int triangle : edge.triangles)
    if (triangle >= 0)
      spring.stiffness +=
          membrane_stiffness(sheet, triangle) * rest_area(sheet, triangle) / along.squaredNorm();
  const Vec3 direction = along / spring.rest_length;
  spring.damping = element_damping<2>(damping_rate(sheet, edge.triangles[0]), spring.vertices,
                                      {-direction, direction}, inverse_masses);
  return spring;
}

static int corner_across(const Sheet& sheet, int triangle, const Edge& edge) {
  for (const int vertex : sheet.triangles[triangle])
    if (vertex != edge.vertices[0] && vertex != edge.vertices[1]) return vertex;
  return -1;
}

static std::array<int, 4> bending_vertices(const Sheet& sheet, const Edge& edge) {
  return {corner_across(sheet, edge.triangles[0], edge), corner_across(sheet, edge.triangles[1], edge),
          edge.vertices[0], edge.vertices[1]};
}

// With sin(theta / 2) for theta / 2, BMF03's force is the gradient of 1/8 k_e |E|2 / (A1 + A2) theta2, as |N|
// = 2 A. A plate of flexural rigidity B that is bent to a cylinder stores 1/2 B curvature2 an area; on an
// equilateral mesh hinges store that, in whatever direction they are bent, if each stores 1/2 B |E|2 / (A1 +
// A2) theta2 (Seung and Nelson 1988, Defects in flexible membranes with crystalline order: B = sqrt(3)/2 of
// their constant); so k_e = 4 B.
static double bending_stiffness(const Sheet& sheet, const Edge& edge) {
  double rigidity = 0, normals = 0;
  for (const int triangle : edge.triangles) {
    rigidity += flexural_rigidity(sheet, triangle) / 2;
    normals += 2 * rest_area(sheet, triangle);
  }
  const Vec3 along = sheet.rest_positions[edge.vertices[1]] - sheet.rest_positions[edge.vertices[0]];
  return 4 * rigidity * along.squaredNorm() / normals;
}

static BendingElement build_bending_element(const Sheet& sheet, const Edge& edge,
                                            const std::vector<double>& inverse_masses) {
  constexpr double flat = 1e-9;
  const std::array<int, 4> vertices = bending_vertices(sheet, edge);
  const BendingAngle angle = bending_angle(vertices, sheet.rest_positions);
  const double rest_sine = std::abs(angle.half_sine) < flat ? 0 : angle.half_sine;
  const double damping =
      element_damping<4>(damping_rate(sheet, edge.triangles[0]), vertices, angle.gradients, inverse_masses);
  std::array<double, 4> lengths;
  for (int i = 0; i < 4; ++i) lengths[i] = angle.gradients[i].norm();
  return {vertices, lengths, rest_sine, bending_stiffness(sheet, edge), damping};
}

static std::vector<int> slot_vertices(const MassSpringModel& model) {
  std::vector<int> vertices;
  for (const Spring& spring : model.springs)
    vertices.insert(vertices.end(), spring.vertices.begin(), spring.vertices.end());
  for (const BendingElement& element : model.bending)
    vertices.insert(vertices.end(), element.vertices.begin(), element.vertices.end());
  return vertices;
}

MassSpringModel build_mass_spring(const Sheet& sheet, const std::vector<double>& masses,
                                  const std::vector<char>& pinned) {
  MassSpringModel model{};
  for (std::size_t v = 0; v < masses.size(); ++v)
    model.inverse_masses.push_back(pinned[v] ? 0 : 1 / masses[v]);
  for (const Edge& edge : sheet.topology.edges) {
    model.springs.push_back(build_spring(sheet, edge, model.inverse_masses));
    if (edge.triangles[1] >= 0)
      model.bending.push_back(build_bending_element(sheet, edge, model.inverse_masses));
  }
  model.incidence = build_incidence(static_cast<int>(masses.size()), slot_vertices(model));
  model.stable_step = largest_stable_step(model);
  return model;
}

}  // namespace drape
