#pragma once

#include <vector>

#include "contact/contact_geometry.h"
#include "simulation/input.h"

namespace drape {

// The contact primitives of a collider in its own frame: a sphere is a point with a radius, a capsule an edge
// with one, a box, a
// cylinder and a mesh their triangles; a plane has none.
struct ColliderPrimitives {
  std::vector<Vec3> points;
  std::vector<std::array<int, 2>> edges;
  std::vector<Triangle> triangles;
  double radius = 0;
};
ColliderPrimitives collider_primitives(const ColliderShape& shape);

}  // namespace drape
