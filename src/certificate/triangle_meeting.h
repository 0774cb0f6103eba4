#pragma once

#include <array>

#include "core/vector.h"

namespace drape {

// Closed triangles, whose corners may lie on one line or at one point. All answers are exact for coordinates
// as orientation.h takes them.
using TrianglePoints = std::array<Vec3, 3>;

// Whether the closed segment from p to q meets the triangle; touching is meeting.
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const TrianglePoints& triangle);

// Whether two triangles without a common corner meet; touching is meeting.
bool triangles_meet(const TrianglePoints& a, const TrianglePoints& b);

// Whether two triangles whose first corner is the same point have more than this point in common.
bool meet_beyond_vertex(const TrianglePoints& a, const TrianglePoints& b);

// Whether two triangles whose first two corners are the same points have more than this edge in common: where
// one is folded flat onto the other.
bool meet_beyond_edge(const TrianglePoints& a, const TrianglePoints& b);

}  // namespace drape
