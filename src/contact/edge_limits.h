#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/incidence.h"
#include "core/vector.h"

namespace drape {

// How short and how long edges may be left by a step, colour by colour: no two of a colour share a vertex.
struct EdgeLimits {
  struct Edge {
    std::array<int, 2> vertices;
    double shortest, longest;  // m
  };
  std::vector<Edge> edges;
  std::vector<std::size_t> color_begin;  // of colour c: edges[color_begin[c] .. color_begin[c + 1])
  Incidence incidence;                   // the slots 2 e and 2 e + 1 are of edge e
};

// Of edges in the order of their colours.
EdgeLimits make_edge_limits(std::vector<EdgeLimits::Edge> edges, std::vector<std::size_t> color_begin,
                            int vertices);

// For each edge, 1 where it may be out of its limits, otherwise 0: most of a cloth is within them.
using EdgesInDoubt = std::vector<unsigned char>;

// Those that are out of them.
EdgesInDoubt find_edges_out_of_limits(const EdgeLimits& limits, const std::vector<Vec3>& x);

// When something has moved a vertex.
void doubt_edges_at(const EdgeLimits& limits, int vertex, EdgesInDoubt& in_doubt);

// Contact moves points and not cloth: one that is pushed aside alone leaves its edges too long on one side
// and too short on the other; and what one elastic sweep leaves undone stretches edges where cloth whips.
// Here the cloth around takes its share, in up to five Gauss-Seidel sweeps (after Provot 1995, Deformation
// Constraints in a Mass-Spring Model). They keep linear momentum, and angular momentum but for what points
// are moved, which is of second order. Vertices of inverse mass 0 stay. Looks at the edges in doubt; those
// that five sweeps leave stay in doubt.
void pull_within_limits(const EdgeLimits& limits, const std::vector<double>& inverse_masses,
                        EdgesInDoubt& in_doubt, std::vector<Vec3>& x);

}  // namespace drape
