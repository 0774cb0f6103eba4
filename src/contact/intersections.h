#pragma once

#include <utility>
#include <vector>

#include "core/vector.h"
#include "mesh/triangle_mesh.h"

namespace drape {

// All pairs of triangles that intersect, the smaller index first, ascending. Of two triangles with a common
// vertex only those count that meet beyond it; neighbours across an edge cannot but where one folds flat onto
// the other. Positions are floats, as a frame holds them, and the answer is about exactly these: signs of
// determinants are computed exactly. Touching counts as intersecting.
std::vector<std::pair<int, int>> intersecting_triangles(const std::vector<Vec3f>& positions,
                                                        const std::vector<Triangle>& triangles);

}  // namespace drape
