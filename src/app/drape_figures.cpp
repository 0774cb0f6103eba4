#include "app/drape_figures.h"

#include <cmath>
#include <numbers>

#include "mesh/shadow.h"

namespace drape::app {

// A fold is what stands out of the outline by this share of the ring's width, 1.8 mm in Cusick's ring of 6
// cm: more than the facets of a mesh and ripples do, less than any fold that an eye would count.
static constexpr double least_fold = 0.03;
static constexpr int directions = 720;

// The points of all cloths lie one after another.
static std::vector<Vec3> positions_of_cloth(const SceneDescription& scene, const CachedFrame& frame,
                                            int cloth) {
  auto begin = frame.positions.begin();
  for (int i = 0; i < cloth; ++i)
    begin += static_cast<std::ptrdiff_t>(scene.cloths[i].input.mesh.positions.size());
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < scene.cloths[cloth].input.mesh.positions.size(); ++i)
    positions.push_back(begin[static_cast<std::ptrdiff_t>(i)].cast<double>());
  return positions;
}

DrapeFigures measure_drape(const SceneDescription& scene, const CachedFrame& frame) {
  const auto& [cloth, support] = *scene.drape_test;
  const TriangleMesh& mesh = scene.cloths[cloth].input.mesh;
  const std::vector<Vec3> positions = positions_of_cloth(scene, frame, cloth);

  const double table_radius = std::get<CylinderShape>(scene.colliders[support].input.shape).radius;
  const double table = std::numbers::pi * table_radius * table_radius;
  const double flat = surface_area(mesh.positions, mesh.triangles);
  const double ring_width = std::sqrt(flat / std::numbers::pi) - table_radius;

  DrapeFigures figures;
  figures.coefficient = 100 * (shadow_area(positions, mesh.triangles) - table) / (flat - table);
  figures.folds = count_maxima(
      shadow_outline(positions, mesh.triangles, frame.collider_poses[support].translation, directions),
      least_fold * ring_width);
  return figures;
}

}  // namespace drape::app
