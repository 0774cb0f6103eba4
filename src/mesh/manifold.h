#pragma once

#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace drape {

// What makes the mesh unfit for simulation, each with the triangles (counted from 1): coordinates that are
// not finite, indices out of range, degenerate triangles, more than two triangles on an edge, neighbours of
// opposite orientation, points where two fans touch, points of no triangle, more than 5 million points.
// Empty: it is fit.
std::vector<std::string> check_manifold(const TriangleMesh& mesh);

}  // namespace drape
