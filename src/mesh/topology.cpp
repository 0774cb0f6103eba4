#include "mesh/topology.h"

#include <algorithm>
#include <numeric>

#include "mesh/disjoint_sets.h"
#include "mesh/half_edge.h"

namespace drape {

static void build_edges(const std::vector<Triangle>& triangles, Topology& topology) {
  topology.triangle_edges.resize(triangles.size());
  for_each_edge(sorted_half_edges(triangles), [&](auto begin, auto end) {
    const int edge = static_cast<int>(topology.edges.size());
    for (auto side = begin; side != end; ++side) topology.triangle_edges[side->triangle][side->corner] = edge;
    const int second = end - begin > 1 ? (begin + 1)->triangle : -1;
    topology.edges.push_back({{begin->low, begin->high}, {begin->triangle, second}});
  });
}

// Counting sort by vertex: triangles are visited in ascending order, so each vertex has its own ascending.
static void build_vertex_triangles(int vertex_count, const std::vector<Triangle>& triangles,
                                   Topology& topology) {
  std::vector<int>& begin = topology.vertex_triangle_begin;
  begin.assign(vertex_count + 1, 0);
  for (const Triangle& triangle : triangles)
    for (const int vertex : triangle) ++begin[vertex + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<int> next(begin.begin(), begin.end() - 1);
  topology.vertex_triangles.resize(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (const int vertex : triangles[t]) topology.vertex_triangles[next[vertex]++] = t;
}

Topology build_topology(int vertex_count, const std::vector<Triangle>& triangles) {
  Topology topology;
  build_edges(triangles, topology);
  build_vertex_triangles(vertex_count, triangles, topology);
  return topology;
}

int opposite_vertex(const Topology& topology, const std::vector<Triangle>& triangles, int triangle, int k) {
  const Edge& edge = topology.edges[topology.triangle_edges[triangle][k]];
  const int across = edge.triangles[0] == triangle ? edge.triangles[1] : edge.triangles[0];
  if (across < 0) return -1;
  for (const int vertex : triangles[across])
    if (vertex != edge.vertices[0] && vertex != edge.vertices[1]) return vertex;
  return -1;
}

bool is_closed(const Topology& topology) {
  return std::all_of(topology.edges.begin(), topology.edges.end(),
                     [](const Edge& edge) { return edge.triangles[1] >= 0; });
}

std::vector<int> connected_pieces(int vertex_count, const std::vector<Triangle>& triangles) {
  DisjointSets sets(vertex_count);
  for (const Triangle& triangle : triangles) {
    sets.join(triangle[0], triangle[1]);
    sets.join(triangle[0], triangle[2]);
  }
  // A set is named by its smallest vertex, which therefore comes first and gives the piece its number.
  std::vector<int> pieces(vertex_count);
  int count = 0;
  for (int v = 0; v < vertex_count; ++v) pieces[v] = sets.find(v) == v ? count++ : pieces[sets.find(v)];
  return pieces;
}

}  // namespace drape
