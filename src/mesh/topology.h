#pragma once

#include <array>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace drape {

// An edge and its one or two triangles.
struct Edge {
  std::array<int, 2> vertices;   // smaller index first
  std::array<int, 2> triangles;  // the second is -1 on a boundary
};

// What is next to what; fixed once built. Needs a mesh that check_manifold accepts.
struct Topology {
  std::vector<Edge> edges;                         // sorted by vertices
  std::vector<std::array<int, 3>> triangle_edges;  // edge k of a triangle joins its corners k and (k+1) % 3
  std::vector<int> vertex_triangle_begin;  // triangles of vertex v: vertex_triangles[begin[v] .. begin[v+1])
  std::vector<int> vertex_triangles;       // ascending for each vertex
};
Topology build_topology(int vertex_count, const std::vector<Triangle>& triangles);

// The corner of `triangle` that is not on the edge between its corners k and (k+1) % 3 of the triangle across
// that edge; -1 on a boundary.
int opposite_vertex(const Topology& topology, const std::vector<Triangle>& triangles, int triangle, int k);

// True where each edge has two triangles: what is inside is cut off from what is outside.
bool is_closed(const Topology& topology);

// The numbers of the connected pieces, one for each vertex, counted from 0 in order of their smallest vertex.
std::vector<int> connected_pieces(int vertex_count, const std::vector<Triangle>& triangles);

}  // namespace drape
