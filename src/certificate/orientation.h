#pragma once

#include "core/vector.h"

namespace drape {

// Signs of determinants, exact for all coordinates that are 0 or between 1e-60 and 1e60 in size.

// On which side of the plane (a, b, c) d lies: the sign of det(a - d, b - d, c - d); 0 where the four lie in
// one plane.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

// The same in the plane that is left without the coordinate `axis` (0, 1, 2): on which side of the line (a,
// b) c lies; 0 where the three projections lie on one line.
int orientation_without(int axis, const Vec3& a, const Vec3& b, const Vec3& c);

// An axis without which the three are still the corners of a triangle; -1 where they lie on one line.
int projection_axis(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace drape
