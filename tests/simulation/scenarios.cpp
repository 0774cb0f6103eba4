#include "simulation/scenarios.h"

#include <algorithm>

#include "certificate/surface_certificate.h"
#include "mesh/primitives.h"

namespace drape::test {

ClothInput sheet(double side, int points, double height) {
  ClothInput cloth;
  cloth.name = "sheet";
  cloth.mesh = make_grid({side, side}, {points, points});
  for (const Vec3& p : cloth.mesh.positions) cloth.start_positions.push_back(p + Vec3(0, height, 0));
  return cloth;
}

ClothInput standing_sheet(double side, int points, double height) {
  ClothInput cloth = sheet(side, points, 0);
  for (Vec3& p : cloth.start_positions) p = Vec3(p.x(), p.z() + 0.5 * side + height, 0);
  return cloth;
}

SimulationInput simulate_alone(ClothInput cloth) {
  SimulationInput input;
  input.sleep = false;
  input.cloths.push_back(std::move(cloth));
  return input;
}

void remove_air(SimulationInput& input) { input.wind.drag = input.wind.tangential_drag = 0; }

ClothInput ball(double radius, int segments) {
  ClothInput cloth;
  cloth.name = "ball";
  cloth.mesh = make_sphere(radius, segments, segments / 2);
  cloth.start_positions = cloth.mesh.positions;
  return cloth;
}

ColliderInput ground() { return {"ground", PlaneShape{}, {}, 0.3}; }

std::vector<double> point_masses(const Simulation& simulation) {
  std::vector<double> result;
  for (const ClothInput& cloth : simulation.input().cloths) {
    const std::size_t first = result.size();
    const std::vector<Vec3>& x = cloth.mesh.positions;
    result.resize(first + x.size(), 0.0);
    for (const auto& [a, b, c] : cloth.mesh.triangles) {
      const double area = 0.5 * (x[b] - x[a]).cross(x[c] - x[a]).norm();
      for (const int v : {a, b, c}) result[first + v] += cloth.material.elastic.density * area / 3;
    }
  }
  return result;
}

Vec3 linear_momentum(const Simulation& simulation) {
  const std::vector<double> m = point_masses(simulation);
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < m.size(); ++v) sum += m[v] * simulation.state().velocities[v];
  return sum;
}

Vec3 angular_momentum(const Simulation& simulation) {
  const std::vector<double> m = point_masses(simulation);
  const State& state = simulation.state();
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < m.size(); ++v) sum += m[v] * state.positions[v].cross(state.velocities[v]);
  return sum;
}

int intersecting_pairs(const Simulation& simulation) {
  std::vector<Vec3> points;
  for (const Vec3& p : simulation.state().positions) points.push_back(p.cast<float>().cast<double>());
  std::vector<Triangle> triangles;
  int first = 0;
  for (const ClothInput& cloth : simulation.input().cloths) {
    for (const auto& [a, b, c] : cloth.mesh.triangles) triangles.push_back({a + first, b + first, c + first});
    first += static_cast<int>(cloth.mesh.positions.size());
  }
  return static_cast<int>(intersecting_triangles(points, triangles).size());
}

double lowest_point(const Simulation& simulation) {
  double lowest = 1e300;
  for (const Vec3& p : simulation.state().positions) lowest = std::min(lowest, p.y());
  return lowest;
}

FrameStatistics advance(Simulation& simulation, int frames) {
  FrameStatistics statistics;
  for (int i = 0; i < frames; ++i) statistics = simulation.advance_frame();
  return statistics;
}

}  // namespace drape::test
