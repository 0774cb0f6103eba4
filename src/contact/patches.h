#pragma once

#include <vector>

#include "contact/contact_geometry.h"

namespace drape {

// A small piece of one body. Each of the body's points, edges and triangles is in one patch.
struct Patch {
  int body = 0;
  std::vector<int> points, edges, triangles;
  std::vector<int> vertices;  // all that these have
};

// Patches of a few neighbouring points (in the rest shape), which move much alike. Those of a body come one
// after another.
std::vector<Patch> cut_into_patches(const ContactGeometry& geometry);

// A box of doubles. The fourth value is 0 and makes up a vector register.
struct Bounds {
  Vec4 lower, upper;
};

inline void include(Bounds& bounds, const Vec4& point) {
  bounds.lower = bounds.lower.cwiseMin(point);
  bounds.upper = bounds.upper.cwiseMax(point);
}

template <typename Vertices>
Bounds bounds_of(const std::vector<Vec3>& x, const Vertices& vertices) {
  Vec3 lower = x[*vertices.begin()], upper = lower;
  for (const int v : vertices) {
    lower = lower.cwiseMin(x[v]);
    upper = upper.cwiseMax(x[v]);
  }
  return {padded(lower), padded(upper)};
}

// Whether the two come within `reach` of each other along every axis.
inline bool near(const Bounds& a, const Bounds& b, double reach) {
  return a.lower.x() - reach <= b.upper.x() && b.lower.x() - reach <= a.upper.x() &&
         a.lower.y() - reach <= b.upper.y() && b.lower.y() - reach <= a.upper.y() &&
         a.lower.z() - reach <= b.upper.z() && b.lower.z() - reach <= a.upper.z();
}

}  // namespace drape
