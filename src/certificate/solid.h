#pragma once

#include <variant>
#include <vector>

#include "certificate/triangle_meeting.h"
#include "mesh/triangle_mesh.h"

namespace drape {

// What no cloth may enter, in its own frame.
struct HalfSpace {};     // y <= 0
struct RoundedSegment {  // all points within `radius` of the segment; a ball where its ends are one point
  Vec3 from, to;
  double radius;  // m
};
struct Plane {
  Vec3 normal;  // of unit length
  double offset;
};
struct ConvexSolid {  // where normal.x <= offset for all planes
  std::vector<Plane> planes;
};
using Solid = std::variant<HalfSpace, RoundedSegment, ConvexSolid>;

// Of a closed convex surface, counter-clockwise from outside.
ConvexSolid convex_solid(const TriangleMesh& mesh);

// How deep the triangle reaches into the solid, in m: the way out for its deepest point, of a convex solid
// for its deepest corner. 0 outside, and for what is not finite.
double depth_in(const Solid& solid, const TrianglePoints& triangle);

}  // namespace drape
