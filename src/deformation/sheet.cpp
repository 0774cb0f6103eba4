#include "deformation/sheet.h"

#include <algorithm>

namespace drape {

double rest_area(const Sheet& sheet, int triangle) {
  const auto& [a, b, c] = sheet.triangles[triangle];
  const std::vector<Vec3>& x = sheet.rest_positions;
  return 0.5 * (x[b] - x[a]).cross(x[c] - x[a]).norm();
}

double rest_length(const Sheet& sheet, const Edge& edge) {
  return (sheet.rest_positions[edge.vertices[1]] - sheet.rest_positions[edge.vertices[0]]).norm();
}

std::vector<double> mean_edge_lengths(const Sheet& sheet) {
  std::vector<double> sums(sheet.materials.size(), 0.0), counts(sheet.materials.size(), 0.0);
  for (const Edge& edge : sheet.topology.edges) {
    const int material = sheet.triangle_materials[edge.triangles[0]];
    sums[material] += rest_length(sheet, edge);
    counts[material] += 1;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= std::max(counts[i], 1.0);
  return sums;
}

double triangle_mass(const Sheet& sheet, int triangle) {
  return material_of(sheet, triangle).density * rest_area(sheet, triangle);
}

std::vector<double> lumped_masses(const Sheet& sheet) {
  std::vector<double> masses(sheet.rest_positions.size(), 0.0);
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t) {
    const double third = triangle_mass(sheet, t) / 3;
    for (const int vertex : sheet.triangles[t]) masses[vertex] += third;
  }
  return masses;
}

Vec3 warp_in_plane(const Sheet& sheet, int triangle) {
  const auto& [a, b, c] = sheet.triangles[triangle];
  const std::vector<Vec3>& x = sheet.rest_positions;
  const Vec3 edge = (x[b] - x[a]).normalized();
  const Vec3 normal = edge.cross(x[c] - x[a]).normalized();
  const Vec3& warp = sheet.warp_directions[sheet.triangle_materials[triangle]];
  const Vec3 projected = warp - warp.dot(normal) * normal;
  const bool normal_to_triangle = projected.squaredNorm() < 1e-12 * warp.squaredNorm();
  return normal_to_triangle ? edge : projected.normalized();
}

}  // namespace drape
