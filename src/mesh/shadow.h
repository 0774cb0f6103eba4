#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace drape {

// Measures of the shadow that a surface throws straight down: of what its triangles cover, seen along y.

// In m2. What several triangles cover counts once. Exact along 4096 lines, between which the width of the
// shadow is taken for linear: the error is under 0.02 % of the square that holds the shadow.
double shadow_area(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles);

// In m2, of the surface itself: that of its shadow where it lies flat.
double surface_area(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles);

// How far the shadow reaches from `centre` (its y does not matter), in metres, in `directions` directions
// round it at equal angles, from +x towards -z; 0 where it does not cross that ray.
std::vector<double> shadow_outline(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
                                   const Vec3& centre, int directions);

// The number of maxima of a closed curve of values that rise by at least `prominence` over the minima on both
// of their sides; what is smaller is taken for roughness. Needs prominence > 0.
int count_maxima(const std::vector<double>& closed_curve, double prominence);

}  // namespace drape
