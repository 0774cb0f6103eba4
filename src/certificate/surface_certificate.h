#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "core/vector.h"
#include "mesh/triangle_mesh.h"

namespace drape {

// What certifies a surface, by a path of its own: nothing here is shared with the room that makes contact, so
// that a mistake there cannot hide itself. Positions in m; the corners of a triangle are three different
// indices. Triangles with a corner that is not finite meet nothing and are near to nothing. Answers do not
// depend on the number of threads.

using TrianglePair = std::pair<int, int>;  // the smaller index first

// All pairs of triangles that meet, ascending. Of triangles with a common vertex those that meet beyond it,
// of neighbours across an edge those that are folded flat onto each other, and all that have the same three
// corners. Touching is meeting. Exact for coordinates as orientation.h takes them.
std::vector<TrianglePair> intersecting_triangles(const std::vector<Vec3>& positions,
                                                 const std::vector<Triangle>& triangles);

// How near two triangles come to each other.
struct Gap {
  double distance = std::numeric_limits<double>::infinity();  // m
  TrianglePair triangles{-1, -1};
};

struct SurfaceCertificate {
  bool is_finite = true;  // all positions
  std::vector<TrianglePair> intersecting;
  // Over the pairs without a common vertex; 0 where two meet. Infinite where there is no such pair.
  Gap smallest_gap;
};
SurfaceCertificate certify_surface(const std::vector<Vec3>& positions,
                                   const std::vector<Triangle>& triangles);

// Lengths of edges over those at rest.
struct StretchRange {
  double smallest = 1;
  double largest = 1;
};
// Edges without a length at rest are left out. Not a number where a position is none.
StretchRange edge_stretch(const std::vector<Vec3>& rest_positions, const std::vector<Vec3>& positions,
                          const std::vector<Triangle>& triangles);

// The triangles of a surface that meet a triangle of another one, ascending. Exact, as above.
std::vector<int> triangles_that_meet(const std::vector<Vec3>& positions,
                                     const std::vector<Triangle>& triangles,
                                     const std::vector<Vec3>& other_positions,
                                     const std::vector<Triangle>& other_triangles);

}  // namespace drape
