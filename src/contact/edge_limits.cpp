#include "contact/edge_limits.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/parallel.h"

namespace drape {
namespace {

bool is_within(const EdgeLimits::Edge& edge, const std::vector<Vec3>& x) {
  const double squared_length = (x[edge.vertices[1]] - x[edge.vertices[0]]).squaredNorm();
  return (squared_length <= edge.longest * edge.longest) & (squared_length >= edge.shortest * edge.shortest);
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

// The first of [begin, end), or end. Almost all are not: memchr passes over 32 at a time.
std::size_t next_in_doubt(const EdgesInDoubt& in_doubt, std::size_t begin, std::size_t end) {
  const unsigned char* first = in_doubt.data();
  const void* found = std::memchr(first + begin, 1, end - begin);
  return found == nullptr ? end : static_cast<std::size_t>(static_cast<const unsigned char*>(found) - first);
}

// Returns whether an edge of [begin, end) was out of its limits, and could be pulled. Edges of a colour share
// no vertex, but neighbours: two threads may doubt the same edge.
bool sweep_edges(const EdgeLimits& limits, std::size_t begin, std::size_t end,
                 const std::vector<double>& inverse_masses, EdgesInDoubt& in_doubt, std::vector<Vec3>& x) {
  bool pulled = false;
  for (std::size_t e = begin; (e = next_in_doubt(in_doubt, e, end)) != end; ++e) {
    in_doubt[e] = 0;
    const EdgeLimits::Edge& edge = limits.edges[e];
    if (is_within(edge, x) || !pull_edge(edge, inverse_masses, x)) continue;
    for (const int v : edge.vertices) doubt_edges_at(limits, v, in_doubt);
    pulled = true;
  }
  return pulled;
}

bool sweep(const EdgeLimits& limits, const std::vector<double>& inverse_masses, EdgesInDoubt& in_doubt,
           std::vector<Vec3>& x) {
  constexpr std::size_t block = 16384;
  std::atomic<bool> pulled = false;
  for (std::size_t color = 0; color + 1 < limits.color_begin.size(); ++color) {
    const std::size_t first = limits.color_begin[color];
    parallel_blocks(limits.color_begin[color + 1] - first, block,
                    [&](std::size_t begin, std::size_t end, std::size_t) {
                      if (sweep_edges(limits, first + begin, first + end, inverse_masses, in_doubt, x))
                        pulled.store(true, std::memory_order_relaxed);
                    });
  }
  return pulled;
}

}  // namespace

EdgeLimits make_edge_limits(std::vector<EdgeLimits::Edge> edges, std::vector<std::size_t> color_begin,
                            int vertices) {
  std::vector<int> slots;
  for (const EdgeLimits::Edge& edge : edges)
    slots.insert(slots.end(), edge.vertices.begin(), edge.vertices.end());
  return {std::move(edges), std::move(color_begin), build_incidence(vertices, slots)};
}

EdgesInDoubt find_edges_out_of_limits(const EdgeLimits& limits, const std::vector<Vec3>& x) {
  EdgesInDoubt out(limits.edges.size());
  parallel_for_each(out.size(), 2048,
                    [&edges = limits.edges, &out, &x](std::size_t e) { out[e] = !is_within(edges[e], x); });
  return out;
}

void doubt_edges_at(const EdgeLimits& limits, int vertex, EdgesInDoubt& in_doubt) {
  const auto& [begin, slots] = limits.incidence;
  for (std::size_t i = begin[vertex]; i < begin[vertex + 1]; ++i)
    std::atomic_ref(in_doubt[slots[i] / 2]).store(1, std::memory_order_relaxed);
}

void pull_within_limits(const EdgeLimits& limits, const std::vector<double>& inverse_masses,
                        EdgesInDoubt& in_doubt, std::vector<Vec3>& x) {
  constexpr int most_sweeps = 5;
  for (int i = 0; i < most_sweeps; ++i)
    if (!sweep(limits, inverse_masses, in_doubt, x)) return;
}

}  // namespace drape
