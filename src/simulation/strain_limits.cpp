#include "simulation/strain_limits.h"

#include <algorithm>
#include <cmath>

#include "deformation/coloring.h"

namespace drape {
namespace {

constexpr double least_stretch = 0.02, least_compression = 0.05;
constexpr double tension = 400;  // N/m

// Strain along a direction under a tension of 1 N/m along it, in m/N: that of an orthotropic plate.
double compliance_along(const ElasticMaterial& material, double cosine, double sine) {
  const auto& [warp, weft] = material.stretch_stiffness;
  const double c2 = cosine * cosine, s2 = sine * sine;
  return c2 * c2 / warp + s2 * s2 / weft +
         c2 * s2 * (1 / material.shear_stiffness - 2 * material.poisson_ratio / warp);
}

EdgeLimits::Edge limit_edge(const Sheet& sheet, const Edge& edge) {
  const int triangle = edge.triangles[0];
  const ElasticMaterial& material = material_of(sheet, triangle);
  const double length = rest_length(sheet, edge);
  const Vec3 along = sheet.rest_positions[edge.vertices[1]] - sheet.rest_positions[edge.vertices[0]];
  const double cosine = std::min(1.0, std::abs(along.dot(warp_in_plane(sheet, triangle))) / length);
  const double pulled = tension * compliance_along(material, cosine, std::sqrt(1 - cosine * cosine));
  const double stretch = material.strain_limit > 0 ? material.strain_limit : std::max(least_stretch, pulled);
  const double compression = std::min(1.0, std::max(least_compression, pulled));
  return {edge.vertices, (1 - compression) * length, (1 + stretch) * length};
}

}  // namespace

EdgeLimits build_strain_limits(const Sheet& sheet) {
  std::vector<std::array<int, 2>> edges;
  for (const Edge& edge : sheet.topology.edges) edges.push_back(edge.vertices);
  const Coloring coloring = color_elements(static_cast<int>(sheet.rest_positions.size()), edges);
  EdgeLimits limits{{}, coloring.color_begin};
  for (const int e : coloring.order) limits.edges.push_back(limit_edge(sheet, sheet.topology.edges[e]));
  return limits;
}

}  // namespace drape
