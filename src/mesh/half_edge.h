#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace drape {

// One triangle's side from its corner `corner` to the next one.
struct HalfEdge {
  int low, high;  // its points, the smaller index first
  int triangle;
  int corner;
};

inline bool same_edge(const HalfEdge& a, const HalfEdge& b) { return a.low == b.low && a.high == b.high; }

// All sides of all triangles, those of one edge next to each other: sorted by low, high, triangle, corner.
std::vector<HalfEdge> sorted_half_edges(const std::vector<Triangle>& triangles);

// Calls body(begin, end) for the half-edges of each edge, in the order of the edges.
template <typename Body>
void for_each_edge(const std::vector<HalfEdge>& half_edges, const Body& body) {
  for (auto begin = half_edges.begin(); begin != half_edges.end();) {
    auto end = begin + 1;
    while (end != half_edges.end() && same_edge(*begin, *end)) ++end;
    body(begin, end);
    begin = end;
  }
}

}  // namespace drape
