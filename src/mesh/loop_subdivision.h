#pragma once

#include <memory>
#include <vector>

#include "core/vector.h"
#include "mesh/triangle_mesh.h"

namespace drape {

// Loop's subdivision as an operator that is built once for a mesh and applied to each frame. The only file pair
// that includes OpenSubdiv. Boundaries stay where their edges are (edge-and-corner interpolation).
class LoopSubdivision {
 public:
  LoopSubdivision(const TriangleMesh& mesh, int levels);  // 0 to 4
  ~LoopSubdivision();
  LoopSubdivision(LoopSubdivision&&) noexcept;

  const std::vector<Triangle>& triangles() const;     // the refined triangles
  const std::vector<Vec2f>& uvs() const;              // refined linearly; empty where the mesh has none
  const std::vector<Triangle>& uv_triangles() const;
  std::vector<Vec3f> apply(const std::vector<Vec3f>& positions) const;  // one for each coarse point -> refined

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

// Normals of unit length at the points, weighted by angle and area of the triangles round them.
std::vector<Vec3f> vertex_normals(const std::vector<Vec3f>& positions, const std::vector<Triangle>& triangles);

}  // namespace drape
