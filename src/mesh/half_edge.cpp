#include "mesh/half_edge.h"

#include <algorithm>
#include <tuple>

namespace drape {

std::vector<HalfEdge> sorted_half_edges(const std::vector<Triangle>& triangles) {
  std::vector<HalfEdge> half_edges;
  half_edges.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      half_edges.push_back({low, high, t, k});
    }
  const auto key = [](const HalfEdge& e) { return std::tie(e.low, e.high, e.triangle, e.corner); };
  std::sort(half_edges.begin(), half_edges.end(),
            [&](const HalfEdge& a, const HalfEdge& b) { return key(a) < key(b); });
  return half_edges;
}

}  // namespace drape
