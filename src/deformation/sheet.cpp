#include "deformation/sheet.h"

namespace drape {

double rest_area(const Sheet& sheet, int triangle) {
  const auto& [a, b, c] = sheet.triangles[triangle];
  const std::vector<Vec3>& x = sheet.rest_positions;
  return 0.5 * (x[b] - x[a]).cross(x[c] - x[a]).norm();
}

std::vector<double> lumped_masses(const Sheet& sheet) {
  std::vector<double> masses(sheet.rest_positions.size(), 0.0);
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t) {
    const double third = sheet.materials[sheet.triangle_materials[t]].density * rest_area(sheet, t) / 3;
    for (const int vertex : sheet.triangles[t]) masses[vertex] += third;
  }
  return masses;
}

}  // namespace drape
