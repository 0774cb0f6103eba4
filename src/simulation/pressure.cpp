#include "simulation/pressure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/topology.h"

namespace drape {
namespace {

// Six times the volume between the triangle and the origin; over a closed piece it adds up to the piece's,
// positive where the triangles turn counter-clockwise seen from outside.
double signed_volume(const TriangleMesh& mesh, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  return mesh.positions[a].dot(mesh.positions[b].cross(mesh.positions[c]));
}

void add_pressures(const ClothInput& cloth, std::vector<double>& pressures) {
  const TriangleMesh& mesh = cloth.mesh;
  const std::vector<int> piece_of = connected_pieces(static_cast<int>(mesh.positions.size()), mesh.triangles);
  std::vector<double> volumes(mesh.positions.size(), 0.0);  // of each piece
  for (const Triangle& triangle : mesh.triangles)
    volumes[piece_of[triangle[0]]] += signed_volume(mesh, triangle);
  for (const Triangle& triangle : mesh.triangles)
    pressures.push_back(std::copysign(cloth.pressure, cloth.pressure * volumes[piece_of[triangle[0]]]));
}

}  // namespace

std::vector<double> triangle_pressures(const std::vector<ClothInput>& cloths) {
  const bool has_any =
      std::any_of(cloths.begin(), cloths.end(), [](const ClothInput& cloth) { return cloth.pressure != 0; });
  std::vector<double> pressures;
  for (const ClothInput& cloth : cloths)
    if (has_any) add_pressures(cloth, pressures);
  return pressures;
}

double doubling_pressure(const ClothInput& cloth) {
  double area = 0;
  for (const auto& [a, b, c] : cloth.mesh.triangles) {
    const std::vector<Vec3>& x = cloth.mesh.positions;
    area += 0.5 * (x[b] - x[a]).cross(x[c] - x[a]).norm();
  }
  const auto& [warp, weft] = cloth.material.elastic.stretch_stiffness;
  return std::min(warp, weft) / std::sqrt(area / (4 * std::numbers::pi));
}

}  // namespace drape
