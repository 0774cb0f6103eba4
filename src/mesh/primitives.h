#pragma once

#include "mesh/triangle_mesh.h"

namespace drape {

// A rectangle of size[0] x size[1] metres in the plane y = 0, centred on the origin, with points[0] x
// points[1] points in rows along +x, the front upward (+y). Each cell is cut along the same diagonal: 2
// (px-1)(pz-1) triangles. Texture coordinates run from 0 to 1 along +x and +z. Needs at least 2 x 2 points.
TriangleMesh make_grid(const std::array<double, 2>& size, const std::array<int, 2>& points);

// A round piece of that diameter (metres) in the plane y = 0, centred on the origin, the front upward (+y).
// All edges are between 0.75 and 1.4 times `edge` long, and the boundary's points lie on the circle, evenly.
// Texture coordinates run from 0 to 1 along +x and +z. Needs 0 < edge <= diameter / 4.
TriangleMesh make_disc(double diameter, double edge);

// About the number of points that make_disc gives, without making them; may be more than an int holds.
double count_disc_points(double diameter, double edge);

// Closed surfaces round the origin, counter-clockwise from outside.
TriangleMesh make_sphere(double radius, int segments, int rings);
TriangleMesh make_box(const Vec3& size);  // 8 points, 12 triangles
// A capsule round the segment from a to b.
TriangleMesh make_capsule(const Vec3& a, const Vec3& b, double radius, int segments, int rings);
// A cylinder along y between y = -height / 2 and height / 2: a fan on each end, and a band round the side.
// Its points lie on the circle, so that it is a prism within the cylinder.
TriangleMesh make_cylinder(double radius, double height, int segments);

// Of a cylinder that cloth falls on and that is drawn: its sides are within 0.06 % of the radius from the
// circle.
inline constexpr int cylinder_segments = 96;

}  // namespace drape
