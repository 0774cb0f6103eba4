#include "mesh/loop_subdivision.h"

namespace drape {

// Source: Nelson Max, "Weights for computing vertex normals from facet normals", 1999: exact on a sphere, and
// no angle is computed, so no libm decides a bit.
static Vec3 weighted_normal(const Vec3& to_next, const Vec3& to_last) {
  const double weight = to_next.squaredNorm() * to_last.squaredNorm();
  return weight > 0 ? Vec3(to_next.cross(to_last) / weight) : Vec3(Vec3::Zero());
}

static Vec3f to_unit(const Vec3& sum) {
  const double length = sum.norm();
  return length > 0 ? Vec3f((sum / length).cast<float>()) : Vec3f(Vec3f::UnitY());
}

std::vector<Vec3f> vertex_normals(const std::vector<Vec3f>& positions,
                                  const std::vector<Triangle>& triangles) {
  std::vector<Vec3> sums(positions.size(), Vec3::Zero());
  for (const Triangle& triangle : triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3 corner = positions[triangle[k]].cast<double>();
      sums[triangle[k]] += weighted_normal(positions[triangle[(k + 1) % 3]].cast<double>() - corner,
                                           positions[triangle[(k + 2) % 3]].cast<double>() - corner);
    }
  std::vector<Vec3f> normals(positions.size());
  for (std::size_t i = 0; i < sums.size(); ++i) normals[i] = to_unit(sums[i]);
  return normals;
}

}  // namespace drape
