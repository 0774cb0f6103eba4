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

// Whether its points move in other ways than as a rigid body.
bool deforms(const ColliderInput& collider);

// Where the points of its primitives are in the world at a time in seconds, if nothing holds it up.
std::vector<Vec3> collider_points(const ColliderInput& collider, double time);

// How far the point is that is farthest from where it would be at that time, of the colliders that deform. In
// m; `points` are those of all colliders.
double largest_shape_lag(const std::vector<ColliderInput>& colliders, double time,
                         const std::vector<Vec3>& points);

// Its pose at that time; where it deforms, none: its points say where it is.
RigidPose collider_pose(const ColliderInput& collider, double time);

}  // namespace drape
