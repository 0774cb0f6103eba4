#pragma once

#include "mesh/triangle_mesh.h"

namespace drape {

// A rectangle of size[0] x size[1] metres in the plane y = 0, centred on the origin, with points[0] x
// points[1] points in rows along +x, the front upward (+y). Each cell is cut along the same diagonal: 2
// (px-1)(pz-1) triangles. Texture coordinates run from 0 to 1 along +x and +z. Needs at least 2 x 2 points.
TriangleMesh make_grid(const std::array<double, 2>& size, const std::array<int, 2>& points);

// Closed surfaces round the origin, counter-clockwise from outside.
TriangleMesh make_sphere(double radius, int segments, int rings);
TriangleMesh make_box(const Vec3& size);  // 8 points, 12 triangles
// A capsule round the segment from a to b.
TriangleMesh make_capsule(const Vec3& a, const Vec3& b, double radius, int segments, int rings);

}  // namespace drape
