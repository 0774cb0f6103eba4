#include "simulation/forces.h"

#include <algorithm>

#include "core/parallel.h"
#include "simulation/plate_in_air.h"
#include "simulation/wind.h"

namespace drape {
namespace {

constexpr std::size_t block = 256;

// Half of it is the triangle's area along its normal.
Vec3 doubled_area(const Triangle& triangle, const std::vector<Vec3>& x) {
  const auto& [a, b, c] = triangle;
  return (x[b] - x[a]).cross(x[c] - x[a]);
}

// What the air sees of four triangles.
struct Plates {
  LaneVec3<Array4> stream;  // m/s: of the air, relative to them
  LaneVec3<Array4> area;    // m2: along the normals
  Array4 mass;              // kg
};

void set_lane(LaneVec3<Array4>& vectors, int lane, const Vec3& value) {
  vectors.x[lane] = value.x();
  vectors.y[lane] = value.y();
  vectors.z[lane] = value.z();
}

void set_plate(const World& world, int t, double time, const std::vector<Vec3>& x,
               const std::vector<Vec3>& velocities, int lane, Plates& plates) {
  const Triangle& triangle = world.sheet.triangles[t];
  const auto& [a, b, c] = triangle;
  const Vec3 air = wind_at(world.input.wind, (x[a] + x[b] + x[c]) / 3, time);
  set_lane(plates.stream, lane, air - (velocities[a] + velocities[b] + velocities[c]) / 3);
  set_lane(plates.area, lane, 0.5 * doubled_area(triangle, x));
  plates.mass[lane] = world.triangle_masses[t];
}

// On the triangles from `first` on, up to four; lanes beyond the last triangle repeat it.
void air_on_triangles(const World& world, std::size_t first, double time, const std::vector<Vec3>& x,
                      const std::vector<Vec3>& velocities, std::vector<Vec3>& forces) {
  Plates plates;
  const std::size_t count = std::min<std::size_t>(4, forces.size() - first);
  for (std::size_t lane = 0; lane < 4; ++lane)
    set_plate(world, static_cast<int>(first + std::min(lane, count - 1)), time, x, velocities,
              static_cast<int>(lane), plates);
  const LaneVec3<Array4> force = lasting_force(force_of_air(world.input.wind, plates.stream, plates.area),
                                               plates.stream, plates.mass, world.steps_per_air * world.step);
  for (std::size_t lane = 0; lane < count; ++lane) {
    const int i = static_cast<int>(lane);
    forces[first + lane] = {force.x[i], force.y[i], force.z[i]};
  }
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
  parallel_for_each((air_forces.size() + 3) / 4, block / 4, [&](std::size_t i) {
    air_on_triangles(world, 4 * i, time, positions, velocities, air_forces);
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
