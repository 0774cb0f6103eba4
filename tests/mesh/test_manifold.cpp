#include <gtest/gtest.h>

#include <limits>

#include "mesh/manifold.h"

namespace drape {
namespace {

using Words = std::vector<std::string>;

// Two triangles on the edge from point 1 to point 2, counted from 0 here and from 1 in messages.
TriangleMesh two_triangles() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}, {}, {}};
}

TEST(Manifold, AcceptsASheet) { EXPECT_EQ(check_manifold(two_triangles()), Words{}); }

TEST(Manifold, NothingThere) {
  EXPECT_EQ(check_manifold(TriangleMesh{}), Words{"the mesh has no triangles"});
}

TEST(Manifold, IndexOutOfRange) {
  TriangleMesh mesh = two_triangles();
  mesh.triangles[1] = {2, -1, 4};
  EXPECT_EQ(check_manifold(mesh), (Words{"triangle 2 names point 0, but they are numbered 1 to 4",
                                         "triangle 2 names point 5, but they are numbered 1 to 4"}));
}

TEST(Manifold, TextureCoordinates) {
  TriangleMesh mesh = two_triangles();
  mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
  mesh.uv_triangles = {{0, 1, 2}};
  EXPECT_EQ(check_manifold(mesh), Words{"the mesh has 2 triangles, but texture coordinates for 1"});
  mesh.uv_triangles.push_back({0, 1, 3});
  EXPECT_EQ(check_manifold(mesh),
            Words{"triangle 2 names texture coordinate 4, but they are numbered 1 to 3"});
}

TEST(Manifold, NotFinite) {
  TriangleMesh mesh = two_triangles();
  mesh.positions[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(check_manifold(mesh),
            Words{"triangle 2 has a corner, point 4, whose coordinates are not finite"});
  mesh.positions[3].y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(check_manifold(mesh).size(), 1u);
}

TEST(Manifold, Degenerate) {
  TriangleMesh mesh = two_triangles();
  mesh.triangles.push_back({3, 1, 3});
  EXPECT_EQ(check_manifold(mesh), Words{"triangle 3 (points 4, 2, 4) names a point twice; delete it"});
  mesh = two_triangles();
  mesh.positions[3] = {2, -1, 0};
  EXPECT_EQ(check_manifold(mesh),
            Words{"triangle 2 (points 3, 2, 4) has no area; merge its points or delete it"});
}

TEST(Manifold, ThreeTrianglesOnAnEdge) {
  TriangleMesh mesh = two_triangles();
  mesh.positions.emplace_back(0, 0, 1);
  mesh.triangles.push_back({1, 2, 4});
  EXPECT_EQ(check_manifold(mesh),
            Words{"the edge from point 2 to point 3 has 3 triangles (1, 2, 3); a surface has at most 2"});
}

TEST(Manifold, ManyTrianglesOnAnEdge) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}}, {}, {}, {}};
  for (int i = 0; i < 9; ++i) {
    mesh.positions.emplace_back(0, 1, i);
    mesh.triangles.push_back({0, 1, i + 2});
  }
  EXPECT_EQ(check_manifold(mesh), Words{"the edge from point 1 to point 2 has 9 triangles (1, 2, 3, 4, 5, "
                                        "...); a surface has at most 2"});
}

TEST(Manifold, OppositeOrientation) {
  TriangleMesh mesh = two_triangles();
  mesh.triangles[1] = {1, 2, 3};
  EXPECT_EQ(check_manifold(mesh),
            Words{"triangles 1 and 2 have opposite orientation; turn one of them over"});
}

TEST(Manifold, FansThatTouchAtAPoint) {
  const TriangleMesh mesh{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}, {}, {}};
  EXPECT_EQ(check_manifold(mesh), Words{"triangles 1 and 2 touch at point 1 only; give each its own point"});
}

TEST(Manifold, PointOfNoTriangle) {
  TriangleMesh mesh = two_triangles();
  mesh.positions.emplace_back(5, 5, 5);
  EXPECT_EQ(check_manifold(mesh), Words{"point 5 belongs to no triangle; delete it"});
}

TEST(Manifold, CountsWhatItDoesNotList) {
  TriangleMesh mesh = two_triangles();
  for (int i = 0; i < 100; ++i) mesh.positions.emplace_back(i, 5, 5);
  const Words problems = check_manifold(mesh);
  ASSERT_EQ(problems.size(), 6u);
  EXPECT_EQ(problems[5], "and 95 more points of no triangle");
}

TEST(Manifold, TooManyPoints) {
  TriangleMesh mesh = two_triangles();
  mesh.positions.resize(5'000'001, Vec3::Zero());
  EXPECT_EQ(check_manifold(mesh), Words{"the mesh has 5000001 points; the most is 5000000"});
}

}  // namespace
}  // namespace drape
