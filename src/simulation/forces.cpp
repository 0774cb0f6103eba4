#include "simulation/forces.h"

#include "core/parallel.h"
#include "simulation/wind.h"

namespace drape {
namespace {

constexpr std::size_t block = 256;
constexpr double air_density = 1.2;  // kg/m3, at 20 degrees Celsius and sea level

// Half of it is the triangle's area along its normal.
Vec3 doubled_area(const Triangle& triangle, const std::vector<Vec3>& x) {
  const auto& [a, b, c] = triangle;
  return (x[b] - x[a]).cross(x[c] - x[a]);
}

// The force of air that streams past a flat plate with the velocity u, at the angle a to its plane:
//   1/2 rho A |u|2 (C_D sin a n + C_T cos a t + C_L sin a cos a l),
// n and t along the parts of u across and along the plate, l at right angles to u. The first two terms are
// pressure and skin friction (Hoerner 1965, Fluid-Dynamic Drag, chapters 2 and 3), the third is the lift of
// Keckeisen et al. 2004 (Interactive Animation of Cloth including Self Collision Detection). It is the same
// for either direction of the normal, and goes to zero smoothly with u.
Vec3 force_of_air(const WindInput& wind, const Vec3& u, const Vec3& area) {
  const double size = area.norm(), speed = u.norm();
  if (!(size > 0 && speed > 0)) return Vec3::Zero();
  const Vec3 normal = area / size;
  const double across = normal.dot(u);
  const Vec3 pressure = wind.drag * across * normal;
  const Vec3 friction = wind.tangential_drag * (u - across * normal);
  const Vec3 lift = wind.lift * (across * normal - across * across / (speed * speed) * u);
  return 0.5 * air_density * size * speed * (pressure + friction + lift);
}

// The same over all the steps that the force will last, cut as an implicit step cuts a linear drag. With f
// the force, u the relative velocity and m the triangle's mass, which makes a third of the mass at its
// corners,
//   sum m |v - w|2 <= before - sum (2 h f.u - h2 |f|2 / m)
// by Cauchy's inequality at each point, and the cut keeps h |f|2 / m under f.u.
Vec3 lasting_force(const Vec3& force, const Vec3& u, double mass, double step) {
  const double power = force.dot(u);
  if (!(power > 0)) return Vec3::Zero();
  return force * (power / (power + step * force.squaredNorm() / mass));
}

Vec3 air_on_triangle(const World& world, int t, double time, const std::vector<Vec3>& x,
                     const std::vector<Vec3>& velocities) {
  const Sheet& sheet = world.sheet;
  const Triangle& triangle = sheet.triangles[t];
  const auto& [a, b, c] = triangle;
  const Vec3 air = wind_at(world.input.wind, (x[a] + x[b] + x[c]) / 3, time);
  const Vec3 u = air - (velocities[a] + velocities[b] + velocities[c]) / 3;
  const Vec3 force = force_of_air(world.input.wind, u, 0.5 * doubled_area(triangle, x));
  return lasting_force(force, u, world.triangle_masses[t], world.steps_per_air * world.step);
}

bool has_air(const WindInput& wind) { return wind.drag > 0 || wind.tangential_drag > 0; }

// Of air and pressure on each triangle.
std::vector<Vec3> with_pressure(const World& world, std::vector<Vec3> forces, const std::vector<Vec3>& x) {
  forces.resize(world.sheet.triangles.size(), Vec3::Zero());
  parallel_for_each(forces.size(), block, [&](std::size_t t) {
    forces[t] += 0.5 * world.pressures[t] * doubled_area(world.sheet.triangles[t], x);
  });
  return forces;
}

}  // namespace

void feel_air(const World& world, double time, const std::vector<Vec3>& positions,
              const std::vector<Vec3>& velocities, std::vector<Vec3>& air_forces) {
  if (!has_air(world.input.wind)) return;
  air_forces.resize(world.sheet.triangles.size());
  parallel_for_each(air_forces.size(), block, [&](std::size_t t) {
    air_forces[t] = air_on_triangle(world, static_cast<int>(t), time, positions, velocities);
  });
}

void external_accelerations(const World& world, const std::vector<Vec3>& air_forces,
                            const std::vector<Vec3>& positions, std::vector<Vec3>& accelerations) {
  std::vector<Vec3> both;
  if (!world.pressures.empty()) both = with_pressure(world, air_forces, positions);
  const std::vector<Vec3>& forces = both.empty() ? air_forces : both;
  const Topology& topology = world.sheet.topology;
  accelerations.resize(positions.size());
  parallel_for_each(positions.size(), block, [&](std::size_t v) {
    accelerations[v] = world.pinned[v] ? Vec3(Vec3::Zero()) : world.input.gravity;
    if (world.pinned[v] || forces.empty()) return;
    Vec3 sum = Vec3::Zero();
    for (int i = topology.vertex_triangle_begin[v]; i < topology.vertex_triangle_begin[v + 1]; ++i)
      sum += forces[topology.vertex_triangles[i]];
    accelerations[v] += sum / (3 * world.masses[v]);
  });
}

}  // namespace drape
