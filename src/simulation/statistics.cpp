#include "simulation/statistics.h"

#include <algorithm>

#include "simulation/colliders.h"

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

static void measure_edges(const World& world, const State& state, FrameStatistics& statistics) {
  std::vector<double> stretches = edge_stretches(world, state);
  const auto [smallest, largest] = std::minmax_element(stretches.begin(), stretches.end());
  statistics.smallest_stretch = *smallest;
  statistics.largest_stretch = *largest;
  const auto p99 =
      stretches.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(stretches.size() - 1));
  std::nth_element(stretches.begin(), p99, stretches.end());
  statistics.p99_stretch = *p99;
}

static void measure_motion(const World& world, const State& state, FrameStatistics& statistics) {
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    statistics.kinetic_energy += 0.5 * world.masses[v] * state.velocities[v].squaredNorm();
    statistics.largest_speed = std::max(statistics.largest_speed, state.velocities[v].norm());
  }
}

static void measure_lags(const World& world, const State& state, FrameStatistics& statistics) {
  const double now = state.frame * world.input.frame_duration;
  for (const double reached : state.collider_times)
    statistics.largest_lag = std::max(statistics.largest_lag, now - reached);
  statistics.largest_pin_lag = largest_pin_lag(world.pins, now, state);
  statistics.largest_shape_lag = largest_shape_lag(world.input.colliders, now, state.collider_points);
}

FrameStatistics measure(const World& world, const State& state) {
  FrameStatistics statistics;
  measure_edges(world, state, statistics);
  measure_motion(world, state, statistics);
  measure_lags(world, state, statistics);
  statistics.contacts = state.contacts;
  return statistics;
}

}  // namespace drape
