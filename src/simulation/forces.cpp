#include "simulation/forces.h"

#include <algorithm>
#include <cmath>

namespace drape {

// The pressure of moving air on one triangle, along its normal: 1/2 rho C v_n |v_n| A with v_n the normal
// part of the wind relative to the triangle; a third goes to each corner. Cut to what takes the relative
// motion away in one step, which air cannot outdo.
static void blow_on_triangle(const World& world, int t, const std::vector<Vec3>& x,
                             const std::vector<Vec3>& velocities, std::vector<Vec3>& accelerations) {
  constexpr double air_density = 1.2;  // kg/m3
  const auto& [a, b, c] = world.sheet.triangles[t];
  const Vec3 cross = (x[b] - x[a]).cross(x[c] - x[a]);
  const double double_area = cross.norm();
  if (!(double_area > 0)) return;
  const Vec3 normal = cross / double_area;
  const WindInput& wind = world.input.wind;
  const double speed = normal.dot(wind.velocity - (velocities[a] + velocities[b] + velocities[c]) / 3);
  const double force = 0.5 * air_density * wind.drag * speed * std::abs(speed) * 0.5 * double_area;
  for (const int v : {a, b, c}) {
    const double change = force / 3 / world.masses[v];
    const double most = std::abs(speed) / 6 / world.step;  // six triangles share a point
    accelerations[v] += std::clamp(change, -most, most) * normal;
  }
}

void external_accelerations(const World& world, const std::vector<Vec3>& positions,
                            const std::vector<Vec3>& velocities, std::vector<Vec3>& accelerations) {
  accelerations.assign(positions.size(), world.input.gravity);
  const bool windy = world.input.wind.drag > 0 && !world.input.wind.velocity.isZero(0);
  for (int t = 0; windy && t < static_cast<int>(world.sheet.triangles.size()); ++t)
    blow_on_triangle(world, t, positions, velocities, accelerations);
  for (std::size_t v = 0; v < accelerations.size(); ++v)
    if (world.pinned[v]) accelerations[v].setZero();
}

}  // namespace drape
