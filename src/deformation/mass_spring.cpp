#include "deformation/mass_spring.h"

#include <algorithm>
#include <cmath>

#include "deformation/bending_angle.h"
#include "deformation/membrane_material.h"

namespace drape {

// The stiffness in N/m of a triangle's membrane along an edge, free to contract across: on the bias of a
// fabric that shears easily, its shear's.
static double membrane_stiffness(const Sheet& sheet, int triangle, const Vec3& direction) {
  const ElasticMaterial& material = material_of(sheet, triangle);
  const double cosine = warp_in_plane(sheet, triangle).dot(direction), c2 = cosine * cosine,
               s2 = std::max(1 - c2, 0.0);
  const Vec3 strain(c2, s2, std::sqrt(c2 * s2));
  return 1 / strain.dot(membrane_tensor(material, Vec2(1, 0)).inverse() * strain);
}

// That of folding about an edge.
static double flexural_rigidity(const Sheet& sheet, int triangle, const Vec3& edge) {
  const auto& [warp, weft] = material_of(sheet, triangle).bend_stiffness;
  const double cosine = warp_in_plane(sheet, triangle).dot(edge);
  return weft * cosine * cosine + warp * (1 - cosine * cosine);
}

// The damping b of an element with gradients g_i and stiffness k. Its rate, alone, dies out as e^(-d t) with
// d = b sum w_i |g_i|2. Kelvin-Voigt's b = damping k would want explicit steps of microseconds (BMF03 damp
// implicitly): an element has no more than a twentieth of its critical damping. Zero where all of its points
// are pinned.
template <std::size_t N>
static double element_damping(double damping, double stiffness, const std::array<int, N>& vertices,
                              const std::array<Vec3, N>& gradients,
                              const std::vector<double>& inverse_masses) {
  constexpr double critical_share = 0.05;
  double response = 0;
  for (std::size_t i = 0; i < N; ++i) response += inverse_masses[vertices[i]] * gradients[i].squaredNorm();
  const double most = response > 0 ? 2 * critical_share * std::sqrt(stiffness / response) : 0;
  return std::min(damping * stiffness, most);
}

static Spring build_spring(const Sheet& sheet, const Edge& edge, const std::vector<double>& inverse_masses) {
  const auto& [a, b] = edge.vertices;
  const Vec3 along = sheet.rest_positions[b] - sheet.rest_positions[a];
  Spring spring{edge.vertices, along.norm(), 0, 0};
  for (const int triangle : edge.triangles)
    if (triangle >= 0)
      spring.stiffness += membrane_stiffness(sheet, triangle, along.normalized()) *
                          rest_area(sheet, triangle) / along.squaredNorm();
  const Vec3 direction = along / spring.rest_length;
  spring.damping = element_damping<2>(material_of(sheet, edge.triangles[0]).damping, spring.stiffness,
                                      spring.vertices, {-direction, direction}, inverse_masses);
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
  const Vec3 along = sheet.rest_positions[edge.vertices[1]] - sheet.rest_positions[edge.vertices[0]];
  double rigidity = 0, normals = 0;
  for (const int triangle : edge.triangles) {
    rigidity += flexural_rigidity(sheet, triangle, along.normalized()) / 2;
    normals += 2 * rest_area(sheet, triangle);
  }
  return 4 * rigidity * along.squaredNorm() / normals;
}

static BendingElement build_bending_element(const Sheet& sheet, const Edge& edge,
                                            const std::vector<double>& inverse_masses) {
  constexpr double flat = 1e-9;
  const std::array<int, 4> vertices = bending_vertices(sheet, edge);
  const BendingAngle angle = bending_angle(vertices, sheet.rest_positions);
  const double rest_sine = std::abs(angle.half_sine) < flat ? 0 : angle.half_sine;
  const double stiffness = bending_stiffness(sheet, edge);
  const double damping =
      element_damping<4>(material_of(sheet, edge.triangles[0]).damping, stiffness / 2, vertices,
                         angle.gradients, inverse_masses);  // sin(theta / 2) is theta / 2
  std::array<double, 4> lengths;
  for (int i = 0; i < 4; ++i) lengths[i] = angle.gradients[i].norm();
  return {vertices, lengths, rest_sine, stiffness, damping};
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
