#pragma once

#include "certificate/triangle_meeting.h"

namespace drape {

// Distances in m, of closed sets, with the rounding errors of double.

double segment_distance(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b);

// 0 where the segment meets the triangle.
double segment_triangle_distance(const Vec3& p, const Vec3& q, const TrianglePoints& triangle);

// The least distance of a corner of one from the other and of an edge of one from an edge of the other: that
// of the triangles where they do not meet.
double triangle_distance(const TrianglePoints& a, const TrianglePoints& b);

}  // namespace drape
