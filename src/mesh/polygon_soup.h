#pragma once

#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace drape {

// Polygons as files hold them: of any number of corners, with points that may be repeated.
struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;
  std::vector<int> corner_points;  // indices into points, polygon after polygon
  std::vector<int> corner_uvs;     // indices into uvs, one for each corner; or empty
  std::vector<int> polygon_ends;   // the number of corners up to and with each polygon
};

// For each point the first point of equal position.
std::vector<int> first_equal_points(const std::vector<Vec3>& points);

// Of two shapes of the same faces: for each point the first one that is at its place in both.
std::vector<int> first_equal_points(const std::vector<Vec3>& points, const std::vector<Vec3>& other_points);

// Of more shapes of them: `first` of the ones before, and where the points are in the next.
std::vector<int> first_equal_points(const std::vector<int>& first, const std::vector<Vec3>& points);

// Whether the polygons of both have the same corners in the same order.
bool have_same_faces(const PolygonSoup& a, const PolygonSoup& b);

// "12 points and 10 faces"
std::string size_text(const PolygonSoup& soup);

// Polygons, given by their corners one after another, cut into fans round their first corner.
std::vector<Triangle> cut_into_fans(const std::vector<int>& corners, const std::vector<int>& polygon_ends);

inline bool has_three_corners(const Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; }

// One mesh of it: polygons cut into fans round their first corner, points of equal position made one (the
// first), triangles dropped that thereby lose their third corner (exporters write the poles of spheres so).
// Needs indices in range and finite points.
TriangleMesh weld(const PolygonSoup& soup);

// One mesh in two shapes: points are made one where they are equal in both. Needs the same faces.
struct ShapedMesh {
  TriangleMesh mesh;  // as at rest
  std::vector<Vec3> start_positions;
};
ShapedMesh weld(const PolygonSoup& rest, const PolygonSoup& start);

// One surface in many shapes: where its points are in each. There is one at least, the soup's own.
struct SoupInShapes {
  PolygonSoup soup;
  std::vector<std::vector<Vec3>> shapes;
};

// One mesh in many shapes, the first of them its own: points are made one where they are equal in all.
struct MeshInShapes {
  TriangleMesh mesh;
  std::vector<std::vector<Vec3>> shapes;
};
MeshInShapes weld(const SoupInShapes& soup);

}  // namespace drape
