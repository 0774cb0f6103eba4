#pragma once

#include <array>
#include <vector>

#include "core/vector.h"

namespace drape {

using Triangle = std::array<int, 3>;

// A surface of triangles, counter-clockwise seen from its front. Points are welded by position: a seam of the
// texture does not cut the surface, so texture coordinates have triangles of their own.
struct TriangleMesh {
  std::vector<Vec3> positions;         // metres
  std::vector<Triangle> triangles;     // indices into positions
  std::vector<Vec2> uvs;               // empty: the mesh has no texture coordinates
  std::vector<Triangle> uv_triangles;  // as long as triangles, indices into uvs; or empty
};

}  // namespace drape
