#pragma once

#include <memory>
#include <vector>

#include "core/vector.h"
#include "mesh/triangle_mesh.h"

namespace drape {

// Loop's subdivision as an operator that is built once for a mesh and applied to each frame. The only file
// pair that includes OpenSubdiv. Boundaries become smooth curves of their own (edge-and-corner
// interpolation), but corners of the sheet at rest, where `mesh` turns by more than 70 degrees, stay sharp.
// Needs a mesh that check_manifold accepts.
class LoopSubdivision {
 public:
  LoopSubdivision(const TriangleMesh& mesh, int levels);  // 0 to 4
  ~LoopSubdivision();
  LoopSubdivision(LoopSubdivision&&) noexcept;

  const std::vector<Triangle>& triangles() const;  // the refined triangles
  const std::vector<Vec2f>& uvs() const;           // refined linearly; empty where the mesh has none
  const std::vector<Triangle>& uv_triangles() const;
  // One position for each coarse point -> one for each refined point: smoothed, or left in the coarse
  // triangles.
  std::vector<Vec3f> apply(const std::vector<Vec3f>& positions) const;
  std::vector<Vec3f> apply_flat(const std::vector<Vec3f>& positions) const;

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

// Normals of unit length at the points: of the triangles round them, the short-sided ones weigh more. (0, 1,
// 0) where there is none.
std::vector<Vec3f> vertex_normals(const std::vector<Vec3f>& positions,
                                  const std::vector<Triangle>& triangles);

}  // namespace drape
