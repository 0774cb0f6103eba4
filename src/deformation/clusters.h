#pragma once

#include <array>
#include <vector>

#include "deformation/sheet.h"

namespace drape {

// For each triangle the corners across its three edges (section 4.1, Fig. 2): what couples neighbours. Where
// one is missing (a boundary) or two coincide, the two that are left and the own corner of best shape; no
// cluster where no choice is well shaped. `materials` gets the triangle's material for each cluster.
std::vector<std::array<int, 3>> outer_corners(const Sheet& sheet, std::vector<int>& materials);

// 2 sqrt(3) |p x q| / (sum of the squared sides): 1 for an equilateral triangle, 0 for collinear points.
double triangle_shape(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace drape
