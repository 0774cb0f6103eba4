#include "hanging_sheet.h"

#include <cmath>

#include "mesh/primitives.h"

namespace drape::bench {
namespace {

Sheet standing_grid(int points, double side, const ElasticMaterial& material) {
  TriangleMesh mesh = make_grid({side, side}, {points, points});
  for (Vec3& x : mesh.positions) x = Vec3(x.x(), side / 2 - x.z(), 0);
  const int count = static_cast<int>(mesh.positions.size());
  return {mesh.positions, mesh.triangles,  std::vector<int>(mesh.triangles.size(), 0),
          {material},     {Vec3(1, 0, 0)}, build_topology(count, mesh.triangles)};
}

bool is_upper_corner(const Vec3& x, double side) {
  constexpr double near = 1e-6;
  return x.y() > side * (1 - near) && std::abs(x.x()) > side * (0.5 - near);
}

}  // namespace

HangingSheet hanging_sheet(int points_a_side, double side, const ElasticMaterial& material) {
  HangingSheet hanging{standing_grid(points_a_side, side, material), {}, {}, {}, side};
  hanging.masses = lumped_masses(hanging.sheet);
  for (const Vec3& x : hanging.sheet.rest_positions) {
    hanging.pinned.push_back(is_upper_corner(x, side) ? 1 : 0);
    hanging.gravity.push_back(hanging.pinned.back() ? Vec3(0, 0, 0) : Vec3(0, -9.81, 0));
  }
  return hanging;
}

std::vector<Vec3> with_corners_pulled(const HangingSheet& hanging) {
  std::vector<Vec3> positions = hanging.sheet.rest_positions;
  for (Vec3& x : positions) {
    const double sideways = 2 * x.x() / hanging.side, below = 1 - x.y() / hanging.side;
    const double share = below * below * sideways * sideways;
    x += share * hanging.side * Vec3(0.02 * sideways, -0.02, 0.05);
  }
  return positions;
}

}  // namespace drape::bench
