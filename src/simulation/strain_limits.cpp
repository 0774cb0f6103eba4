#include "simulation/strain_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "deformation/coloring.h"
#include "deformation/membrane_material.h"

namespace drape {
namespace {

constexpr double least_stretch = 0.02, least_compression = 0.05;
constexpr double tension = 400;  // N/m

// Shares of an edge's length.
struct Strains {
  double stretch, compression;
};

Strains strains_of(const Sheet& sheet, const Edge& edge, int triangle) {
  const ElasticMaterial& material = material_of(sheet, triangle);
  const Vec3 along = sheet.rest_positions[edge.vertices[1]] - sheet.rest_positions[edge.vertices[0]];
  const double cosine = std::clamp(along.normalized().dot(warp_in_plane(sheet, triangle)), -1.0, 1.0);
  // The sign of the sine says nothing: a weave is the same on both sides of its warp.
  const Vec2 direction(cosine, std::sqrt(1 - cosine * cosine));
  const Mat3 compliance = membrane_tensor(material, Vec2::UnitX()).inverse();
  const double pulled = tension / strip_stiffness(compliance, direction);
  const double limit = material.strain_limit > 0 ? material.strain_limit : std::max(least_stretch, pulled);
  return {limit, std::clamp(limit, least_compression, 1.0)};
}

// The tighter ones of the triangles on both sides.
EdgeLimits::Edge limit_edge(const Sheet& sheet, const Edge& edge) {
  Strains strains = strains_of(sheet, edge, edge.triangles[0]);
  if (edge.triangles[1] >= 0) {
    const Strains other = strains_of(sheet, edge, edge.triangles[1]);
    strains = {std::min(strains.stretch, other.stretch), std::min(strains.compression, other.compression)};
  }
  const double length = rest_length(sheet, edge);
  return {edge.vertices, (1 - strains.compression) * length, (1 + strains.stretch) * length};
}

}  // namespace

EdgeLimits build_strain_limits(const Sheet& sheet) {
  std::vector<std::array<int, 2>> edges;
  for (const Edge& edge : sheet.topology.edges) edges.push_back(edge.vertices);
  const int vertices = static_cast<int>(sheet.rest_positions.size());
  const Coloring coloring = color_elements(vertices, edges);
  std::vector<EdgeLimits::Edge> limits;
  for (const int e : coloring.order) limits.push_back(limit_edge(sheet, sheet.topology.edges[e]));
  return make_edge_limits(std::move(limits), coloring.color_begin, vertices);
}

}  // namespace drape
