#pragma once

#include "mesh/triangle_mesh.h"

namespace drape::test {

inline Vec3 area_vector(const TriangleMesh& mesh, const Triangle& t) {
  return 0.5 *
         (mesh.positions[t[1]] - mesh.positions[t[0]]).cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
}

inline double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += area_vector(mesh, t).norm();
  return sum;
}

// By the divergence theorem; positive where the triangles of a closed surface face outward.
inline double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += mesh.positions[t[0]].dot(area_vector(mesh, t)) / 3;
  return sum;
}

}  // namespace drape::test
