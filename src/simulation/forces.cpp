#include "simulation/forces.h"

#include <algorithm>
#include <array>

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

// Vertices of four triangles, corner by corner.
std::array<FourIndices, 3> corners_of(const std::vector<Triangle>& triangles, const FourIndices& four) {
  std::array<FourIndices, 3> corners{};
  for (std::size_t lane = 0; lane < four.size(); ++lane)
    for (std::size_t k = 0; k < corners.size(); ++k) corners[k][lane] = triangles[four[lane]][k];
  return corners;
}

LaneVectors third(const LaneVectors& sum) { return {sum.x / 3, sum.y / 3, sum.z / 3}; }

LaneVectors wind_at(const WindInput& wind, const LaneVectors& places, double time) {
  if (is_steady(wind)) return {wind.velocity.x(), wind.velocity.y(), wind.velocity.z()};
  std::array<Vec3, DoubleLanes::count> each = each_lane(places);
  for (Vec3& vector : each) vector = wind_at(wind, vector, time);
  return load_lanes(each.data(), in_order);
}

// On the triangles from `first` on, up to four; lanes beyond the last triangle repeat it.
void air_on_triangles(const World& world, std::size_t first, double time, const std::vector<Vec3>& x,
                      const std::vector<Vec3>& velocities, std::vector<Vec3>& forces) {
  const std::size_t count = std::min<std::size_t>(DoubleLanes::count, forces.size() - first);
  FourIndices four{};
  for (std::size_t lane = 0; lane < four.size(); ++lane)
    four[lane] = static_cast<int>(first + std::min(lane, count - 1));
  const auto [ia, ib, ic] = corners_of(world.sheet.triangles, four);
  const LaneVectors a = load_lanes(x.data(), ia), b = load_lanes(x.data(), ib), c = load_lanes(x.data(), ic);
  const LaneVectors velocity = third(load_lanes(velocities.data(), ia) + load_lanes(velocities.data(), ib) +
                                     load_lanes(velocities.data(), ic));
  const LaneVectors stream = wind_at(world.input.wind, third(a + b + c), time) - velocity;
  const LaneVectors area = DoubleLanes(0.5) * cross_product(b - a, c - a);
  const LaneVectors force =
      lasting_force(force_of_air(world.input.wind, stream, area), stream,
                    load_lanes(world.triangle_masses.data(), four), world.steps_per_air * world.step);
  const std::array<Vec3, DoubleLanes::count> each = each_lane(force);
  std::copy_n(each.begin(), count, forces.begin() + static_cast<std::ptrdiff_t>(first));
}

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
  parallel_for_each((air_forces.size() + DoubleLanes::count - 1) / DoubleLanes::count,
                    block / DoubleLanes::count, [&](std::size_t i) {
                      air_on_triangles(world, DoubleLanes::count * i, time, positions, velocities,
                                       air_forces);
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
