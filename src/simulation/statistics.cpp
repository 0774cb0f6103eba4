#include "simulation/statistics.h"

#include <algorithm>

namespace drape {

static std::vector<double> edge_stretches(const World& world, const State& state) {
  std::vector<double> stretches;
  stretches.reserve(world.sheet.topology.edges.size());
  for (const Edge& edge : world.sheet.topology.edges) {
    const auto& [a, b] = edge.vertices;
    const double rest = (world.sheet.rest_positions[a] - world.sheet.rest_positions[b]).norm();
    stretches.push_back((state.positions[a] - state.positions[b]).norm() / rest);
  }
  return stretches;
}

FrameStatistics measure(const World& world, const State& state) {
  FrameStatistics statistics;
  std::vector<double> stretches = edge_stretches(world, state);
  const auto [smallest, largest] = std::minmax_element(stretches.begin(), stretches.end());
  statistics.smallest_stretch = *smallest;
  statistics.largest_stretch = *largest;
  const auto p99 =
      stretches.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(stretches.size() - 1));
  std::nth_element(stretches.begin(), p99, stretches.end());
  statistics.p99_stretch = *p99;
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    statistics.kinetic_energy += 0.5 * world.masses[v] * state.velocities[v].squaredNorm();
    statistics.largest_speed = std::max(statistics.largest_speed, state.velocities[v].norm());
  }
  return statistics;
}

}  // namespace drape
