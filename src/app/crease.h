#pragma once

#include <vector>

#include "core/vector.h"
#include "mesh/triangle_mesh.h"
#include "render/view.h"

namespace drape::app {

// The vertices that a surface is drawn with. Where a seam of the texture or a sharp edge runs through a point
// of the mesh, it becomes several vertices.
struct DrawnVertices {
  std::vector<int> point_of;        // of the mesh, for each vertex
  std::vector<int> uv_of;           // -1 where the mesh has no texture coordinates
  std::vector<Triangle> triangles;  // indices of vertices
};

// Splits at seams only; `uv_triangles` may be empty.
DrawnVertices split_at_seams(const std::vector<Triangle>& triangles,
                             const std::vector<Triangle>& uv_triangles);

// A surface at rest, smooth but for the edges whose triangles meet at more than `crease_degrees`, which stay
// hard.
render::Surface surface_with_creases(const TriangleMesh& mesh, double crease_degrees);

}  // namespace drape::app
