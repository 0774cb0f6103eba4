#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "deformation/fibres.h"

namespace drape {
namespace {

struct EdgePair {
  double cosine;  // of the angle between the two edges, both seen from the vertex: -1 is straight
  int first, second;
};

int other_end(const Edge& edge, int vertex) { return edge.vertices[edge.vertices[0] == vertex ? 1 : 0]; }

std::vector<std::vector<int>> edges_at_vertices(const Sheet& sheet) {
  std::vector<std::vector<int>> edges(sheet.rest_positions.size());
  for (int e = 0; e < static_cast<int>(sheet.topology.edges.size()); ++e)
    for (const int vertex : sheet.topology.edges[e].vertices) edges[vertex].push_back(e);
  return edges;
}

Vec3 direction_from(const Sheet& sheet, int edge, int vertex) {
  const int other = other_end(sheet.topology.edges[edge], vertex);
  return (sheet.rest_positions[other] - sheet.rest_positions[vertex]).normalized();
}

std::vector<EdgePair> straight_pairs(const Sheet& sheet, int vertex, const std::vector<int>& edges) {
  const double straight_enough = -std::sqrt(0.5) + 1e-9;  // 135 degrees
  std::vector<EdgePair> pairs;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const double cosine =
          direction_from(sheet, edges[i], vertex).dot(direction_from(sheet, edges[j], vertex));
      if (cosine <= straight_enough) pairs.push_back({cosine, edges[i], edges[j]});
    }
  // Rounded, so that directions equal but for their last bits tie, and the edge numbers decide.
  const auto key = [](const EdgePair& pair) {
    return std::tuple(std::round(pair.cosine * 1e9), pair.first, pair.second);
  };
  std::sort(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return pairs;
}

// For each edge and each of its two ends, the edge that goes on there; -1 for none.
using Continuations = std::vector<std::array<int, 2>>;

void pair_edges(const Sheet& sheet, int vertex, const std::vector<int>& edges, Continuations& next) {
  const auto slot = [&](int edge) -> int& {
    return next[edge][sheet.topology.edges[edge].vertices[0] == vertex ? 0 : 1];
  };
  for (const EdgePair& pair : straight_pairs(sheet, vertex, edges))
    if (slot(pair.first) < 0 && slot(pair.second) < 0) {
      slot(pair.first) = pair.second;
      slot(pair.second) = pair.first;
    }
}

int continuation(const Sheet& sheet, const Continuations& next, int edge, int vertex) {
  return next[edge][sheet.topology.edges[edge].vertices[0] == vertex ? 0 : 1];
}

// The first edge of the chain that `edge` is in, and the vertex it starts from. A loop starts at `edge`
// itself.
std::pair<int, int> chain_start(const Sheet& sheet, const Continuations& next, int edge) {
  int current = edge, vertex = sheet.topology.edges[edge].vertices[0];
  for (int before = continuation(sheet, next, current, vertex); before >= 0 && before != edge;
       before = continuation(sheet, next, current, vertex)) {
    vertex = other_end(sheet.topology.edges[before], vertex);
    current = before;
  }
  return {current, vertex};
}

}  // namespace

std::vector<std::vector<int>> trace_fibres(const Sheet& sheet) {
  const std::vector<std::vector<int>> edges = edges_at_vertices(sheet);
  Continuations next(sheet.topology.edges.size(), {-1, -1});
  for (int v = 0; v < static_cast<int>(edges.size()); ++v) pair_edges(sheet, v, edges[v], next);

  std::vector<std::vector<int>> fibres;
  std::vector<char> used(sheet.topology.edges.size(), 0);
  for (int e = 0; e < static_cast<int>(used.size()); ++e) {
    if (used[e]) continue;
    auto [edge, vertex] = chain_start(sheet, next, e);
    fibres.push_back({vertex});
    while (edge >= 0 && !used[edge]) {
      used[edge] = 1;
      vertex = other_end(sheet.topology.edges[edge], vertex);
      std::vector<int>& fibre = fibres.back();
      const bool meets_itself = std::find(fibre.begin(), fibre.end(), vertex) != fibre.end();
      if (meets_itself) fibres.push_back({other_end(sheet.topology.edges[edge], vertex)});
      fibres.back().push_back(vertex);
      edge = continuation(sheet, next, edge, vertex);
    }
  }
  return fibres;
}

}  // namespace drape
