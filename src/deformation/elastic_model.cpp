#include "deformation/elastic_model.h"

#include <cmath>

namespace drape {

// The clusters' stiffness s in 1/s2, for which a uniform dilation by strain e stores the energy of a
// membrane, k e2 per area: a point at q moves by e q, so 1/2 s sum m |e q|2 = k e2 A, with A the rest area
// that the cluster stands for.
static double membrane_stiffness(const Sheet& sheet, const std::array<int, 3>& cluster,
                                 const std::vector<double>& masses, double stretch_stiffness, double area) {
  double total = 0;
  Vec3 centre = Vec3::Zero();
  for (const int v : cluster) {
    total += masses[v];
    centre += masses[v] * sheet.rest_positions[v];
  }
  centre /= total;
  double inertia = 0;
  for (const int v : cluster) inertia += masses[v] * (sheet.rest_positions[v] - centre).squaredNorm();
  return 2 * stretch_stiffness * area / inertia;
}

static ClusterStage build_own_triangles(const Sheet& sheet, const std::vector<double>& masses,
                                        const std::vector<double>& weights, double step) {
  std::vector<double> stiffness;
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t)
    stiffness.push_back(membrane_stiffness(sheet, sheet.triangles[t], masses,
                                           sheet.materials[sheet.triangle_materials[t]].stretch_stiffness,
                                           rest_area(sheet, t)));
  return build_cluster_stage(sheet, own_triangles(sheet), stiffness, weights, step);
}

// An arc of curvature k shortens its chord L by the share (k L)2 / 24. The outer corners resist that
// shortening as a membrane whose energy, at the curvature of a fold of radius L / 2, is that of bending: S
// (1/6)2 = B (2/L)2.
static double outer_corner_membrane(double bend_stiffness, double side) {
  return 144 * bend_stiffness / (side * side);
}

static ClusterStage build_outer_corners(const Sheet& sheet, const std::vector<double>& masses,
                                        const std::vector<double>& weights, double step) {
  std::vector<int> materials;
  const auto clusters = outer_corners(sheet, materials);
  std::vector<double> stiffness;
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const auto& [a, b, c] = clusters[i];
    const std::vector<Vec3>& x = sheet.rest_positions;
    const double area = 0.5 * (x[b] - x[a]).cross(x[c] - x[a]).norm();
    const double membrane =
        outer_corner_membrane(sheet.materials[materials[i]].bend_stiffness, std::sqrt(2 * area));
    // A cluster of outer corners spans four triangles, and overlaps its neighbours as often.
    stiffness.push_back(membrane_stiffness(sheet, clusters[i], masses, membrane, area / 4));
  }
  return build_cluster_stage(sheet, clusters, stiffness, weights, step);
}

ElasticModel build_elastic_model(const Sheet& sheet, const std::vector<double>& masses,
                                 const std::vector<char>& pinned, double step) {
  std::vector<double> weights = masses, inverse_masses(masses.size());
  for (std::size_t v = 0; v < masses.size(); ++v) {
    if (pinned[v]) weights[v] *= 1e4;
    inverse_masses[v] = pinned[v] ? 0 : 1 / masses[v];
  }
  return {build_hinges(sheet),
          build_outer_corners(sheet, masses, weights, step),
          build_own_triangles(sheet, masses, weights, step),
          build_fibres(sheet, step),
          std::move(inverse_masses),
          step};
}

void pull_to_goals(const ElasticModel& model, FibreScratch& scratch, std::vector<Vec3>& x) {
  constexpr int stiff_passes = 2;
  pull_hinges(model.hinges, model.inverse_masses, model.step, x);
  pull_clusters(model.outer_corners, model.inverse_masses, x);
  for (int pass = 0; pass < stiff_passes; ++pass) {
    pull_fibres(model.fibres, model.inverse_masses, scratch, x);
    pull_clusters(model.own_triangles, model.inverse_masses, x);
  }
}

}  // namespace drape
