#include "deformation/clusters.h"

#include <cmath>
#include <numbers>

namespace drape {

double triangle_shape(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 p = b - a, q = c - a;
  const double sides = p.squaredNorm() + q.squaredNorm() + (c - b).squaredNorm();
  return sides > 0 ? 2 * std::numbers::sqrt3 * p.cross(q).norm() / sides : 0;
}

static bool well_shaped(const Sheet& sheet, const std::array<int, 3>& cluster) {
  constexpr double least_shape = 0.1;
  const auto& [a, b, c] = cluster;
  if (a < 0 || b < 0 || c < 0 || a == b || b == c || a == c) return false;
  const std::vector<Vec3>& x = sheet.rest_positions;
  return triangle_shape(x[a], x[b], x[c]) >= least_shape;
}

// The best of the clusters of two outer corners and one own corner; {-1, -1, -1} where none is well shaped.
// (The corner that both neighbours share would be collinear with them on a regular grid.)
static std::array<int, 3> filled_cluster(const Sheet& sheet, const std::array<int, 3>& outer, int triangle) {
  std::array<int, 3> best = {-1, -1, -1};
  double best_shape = 0;
  for (int missing = 0; missing < 3; ++missing)
    for (const int own : sheet.triangles[triangle]) {
      const std::array<int, 3> cluster = {outer[(missing + 1) % 3], outer[(missing + 2) % 3], own};
      if (!well_shaped(sheet, cluster)) continue;
      const std::vector<Vec3>& x = sheet.rest_positions;
      const double shape = triangle_shape(x[cluster[0]], x[cluster[1]], x[cluster[2]]);
      if (shape > best_shape) {
        best_shape = shape;
        best = cluster;
      }
    }
  return best;
}

std::vector<std::array<int, 3>> outer_corners(const Sheet& sheet, std::vector<int>& materials) {
  std::vector<std::array<int, 3>> clusters;
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t) {
    std::array<int, 3> cluster;
    for (int k = 0; k < 3; ++k) cluster[k] = opposite_vertex(sheet.topology, sheet.triangles, t, k);
    if (!well_shaped(sheet, cluster)) cluster = filled_cluster(sheet, cluster, t);
    if (cluster[0] < 0) continue;
    clusters.push_back(cluster);
    materials.push_back(sheet.triangle_materials[t]);
  }
  return clusters;
}

}  // namespace drape
