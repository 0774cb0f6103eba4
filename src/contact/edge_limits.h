#pragma once

#include <array>
#include <cstddef>
#include <vector>

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
};

// The sweep in which each vertex was moved last. An edge whose vertices stand since it was looked at needs no
// look: most of a cloth is within its limits.
struct RecentMoves {
  std::vector<unsigned char> last_sweep;  // of each vertex; zeros at first
  unsigned char sweeps = 0;               // up to 255: 51 calls
};

// Contact moves points and not cloth: one that is pushed aside alone leaves its edges too long on one side
// and too short on the other; and what one elastic sweep leaves undone stretches edges where cloth whips.
// Here the cloth around takes its share, in up to five Gauss-Seidel sweeps that keep both momenta (after
// Provot 1995, Deformation Constraints in a Mass-Spring Model). Vertices of inverse mass 0 stay. A vertex
// that others have moved since the last call must have moves.sweeps as its last sweep.
void pull_within_limits(const EdgeLimits& limits, const std::vector<double>& inverse_masses,
                        RecentMoves& moves, std::vector<Vec3>& x);

}  // namespace drape
