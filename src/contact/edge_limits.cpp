#include "contact/edge_limits.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/parallel.h"

namespace drape {
namespace {

bool is_within(const EdgeLimits::Edge& edge, const std::vector<Vec3>& x) {
  const double squared_length = (x[edge.vertices[1]] - x[edge.vertices[0]]).squaredNorm();
  return squared_length <= edge.longest * edge.longest && squared_length >= edge.shortest * edge.shortest;
}

// Returns whether it could.
bool pull_edge(const EdgeLimits::Edge& edge, const std::vector<double>& inverse_masses,
               std::vector<Vec3>& x) {
  const auto& [a, b] = edge.vertices;
  const Vec3 way = x[b] - x[a];
  const double length = way.norm(), response = inverse_masses[a] + inverse_masses[b];
  if (!(response > 0 && length > 0)) return false;
  const double excess = length - std::clamp(length, edge.shortest, edge.longest);
  const Vec3 pull = excess / (length * response) * way;
  x[a] += inverse_masses[a] * pull;
  x[b] -= inverse_masses[b] * pull;
  return true;
}

// Returns whether any edge was out of its limits.
bool sweep(const EdgeLimits& limits, const std::vector<double>& inverse_masses, RecentMoves& moves,
           std::vector<Vec3>& x) {
  constexpr std::size_t block = 2048;
  std::atomic<bool> pulled = false;
  const unsigned char number = ++moves.sweeps;
  std::vector<unsigned char>& last = moves.last_sweep;
  for (std::size_t color = 0; color + 1 < limits.color_begin.size(); ++color) {
    const std::size_t begin = limits.color_begin[color];
    parallel_for_each(limits.color_begin[color + 1] - begin, block, [&](std::size_t i) {
      const EdgeLimits::Edge& edge = limits.edges[begin + i];
      const auto& [a, b] = edge.vertices;
      if (std::max(last[a], last[b]) + 1 < number || is_within(edge, x) ||
          !pull_edge(edge, inverse_masses, x))
        return;
      last[a] = last[b] = number;
      pulled.store(true, std::memory_order_relaxed);
    });
  }
  return pulled;
}

}  // namespace

void pull_within_limits(const EdgeLimits& limits, const std::vector<double>& inverse_masses,
                        RecentMoves& moves, std::vector<Vec3>& x) {
  constexpr int most_sweeps = 5;
  for (int i = 0; i < most_sweeps; ++i)
    if (!sweep(limits, inverse_masses, moves, x)) return;
}

}  // namespace drape
