#include "mesh/polygon_soup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "mesh/polygon_soup_stream.h"

namespace drape {
namespace {

std::string to_bytes(const SoupInShapes& soup) {
  std::string bytes;
  write_bytes(soup, [&](std::string_view piece) { bytes += piece; });
  return bytes;
}

// Two triangles of an STL file: no point is shared.
PolygonSoup separate_triangles() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, -0.0}},
          {},
          {0, 1, 2, 3, 4, 5},
          {},
          {3, 6}};
}

TEST(Weld, EqualPositionsBecomeThePointThatCameFirst) {
  const TriangleMesh mesh = weld(separate_triangles());
  EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
}

TEST(Weld, ZeroHasNoSign) {
  PolygonSoup soup = separate_triangles();
  for (int i = 3; i < 6; ++i) soup.points[i].z() = -0.0;
  EXPECT_EQ(weld(soup).positions.size(), 4u);
}

TEST(Weld, SeamsOfTheTextureStay) {
  PolygonSoup soup = separate_triangles();
  soup.corner_uvs = soup.corner_points;
  soup.uvs.resize(6, Vec2(0.5, 0.5));
  const TriangleMesh mesh = weld(soup);
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.uv_triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}));
}

TEST(Weld, PolygonsBecomeFans) {
  const PolygonSoup soup{
      {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}}, {}, {4, 0, 1, 2, 3}, {}, {5}};
  EXPECT_EQ(weld(soup).triangles, (std::vector<Triangle>{{4, 0, 1}, {4, 1, 2}, {4, 2, 3}}));
}

TEST(Weld, TrianglesThatCollapseAreDropped) {
  PolygonSoup soup = separate_triangles();
  soup.points[5] = soup.points[3];
  soup.corner_uvs = soup.corner_points;
  soup.uvs.resize(6, Vec2(0, 0));
  const TriangleMesh mesh = weld(soup);
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.uv_triangles.size(), 1u);
}

// Folded flat, the corners of the two triangles lie in each other; at rest only those of their common edge
// do.
TEST(Weld, PointsOfTwoShapesAreOneWhereTheyAreEqualInBoth) {
  const PolygonSoup rest = separate_triangles();
  PolygonSoup start = rest;
  start.points[5] = start.points[0];
  const ShapedMesh shaped = weld(rest, start);
  EXPECT_EQ(shaped.mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(shaped.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(shaped.start_positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}));
}

TEST(Weld, PointsOfManyShapesAreOneWhereTheyAreEqualInAll) {
  const PolygonSoup first = separate_triangles();
  PolygonSoup second = first, third = first;
  for (Vec3& p : second.points) p.z() += 1;
  third.points[3].z() = 2;  // no more where point 2 is
  const MeshInShapes two = weld(SoupInShapes{first, {first.points, second.points}}),
                     three = weld(SoupInShapes{first, {first.points, second.points, third.points}});
  EXPECT_EQ(two.mesh.positions.size(), 4u);
  EXPECT_EQ(three.mesh.positions.size(), 5u);
  ASSERT_EQ(three.shapes.size(), 3u);
  EXPECT_EQ(three.shapes[0], three.mesh.positions);
  EXPECT_EQ(three.shapes[2][3], Vec3(0, 1, 2));
}

TEST(SoupStream, ComesBackTheSame) {
  PolygonSoup soup = separate_triangles();
  soup.uvs = {{0, 1}};
  soup.corner_uvs = {0, 0, 0, 0, 0, 0};
  const std::vector<std::vector<Vec3>> shapes = {soup.points, std::vector<Vec3>(6, Vec3(1, 2, 3))};
  const auto same = soup_from_bytes(to_bytes({soup, shapes}));
  ASSERT_TRUE(same);
  EXPECT_EQ(same->soup.points, soup.points);
  EXPECT_EQ(same->soup.uvs, soup.uvs);
  EXPECT_EQ(same->soup.corner_points, soup.corner_points);
  EXPECT_EQ(same->soup.corner_uvs, soup.corner_uvs);
  EXPECT_EQ(same->soup.polygon_ends, soup.polygon_ends);
  EXPECT_EQ(same->shapes, shapes);
}

TEST(SoupStream, WritesShapesOutOfTheirOwnMemory) {
  const PolygonSoup soup = separate_triangles();
  const SoupInShapes in_shapes{soup, {soup.points, soup.points}};
  std::vector<const void*> written;
  write_bytes(in_shapes, [&](std::string_view piece) { written.push_back(piece.data()); });
  for (const std::vector<Vec3>& shape : in_shapes.shapes)
    EXPECT_EQ(std::count(written.begin(), written.end(), shape.data()), 1);
}

TEST(SoupStream, RefusesEveryTruncation) {
  const PolygonSoup soup = separate_triangles();
  const std::string bytes = to_bytes({soup, {soup.points, soup.points}});
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(soup_from_bytes(bytes.substr(0, size)));
  EXPECT_FALSE(soup_from_bytes(bytes + '\0'));
}

TEST(SoupStream, RefusesWhatMakesNoSense) {
  const auto refuses = [](auto change) {
    PolygonSoup soup = separate_triangles();
    change(soup);
    return !soup_from_bytes(to_bytes({soup, {}}));
  };
  EXPECT_TRUE(refuses([](PolygonSoup& soup) { soup.points[0].x() = NAN; }));
  EXPECT_TRUE(refuses([](PolygonSoup& soup) { soup.points[0].x() = 1e30; }));
  EXPECT_TRUE(refuses([](PolygonSoup& soup) { soup.corner_points[2] = 6; }));
  EXPECT_TRUE(refuses([](PolygonSoup& soup) { soup.corner_points[2] = -1; }));
  EXPECT_TRUE(refuses([](PolygonSoup& soup) { soup.corner_uvs = {0}; }));
  EXPECT_TRUE(refuses([](PolygonSoup& soup) { soup.corner_uvs = {0, 0, 0, 0, 0, 0}; }));
  EXPECT_TRUE(refuses([](PolygonSoup& soup) { soup.polygon_ends = {2, 6}; }));
  EXPECT_TRUE(refuses([](PolygonSoup& soup) { soup.polygon_ends = {3}; }));
  EXPECT_TRUE(refuses([](PolygonSoup& soup) { soup.polygon_ends = {6, 3}; }));
}

TEST(SoupStream, RefusesShapesThatMakeNoSense) {
  const PolygonSoup soup = separate_triangles();
  std::vector<Vec3> fewer(soup.points.begin(), soup.points.end() - 1), infinite = soup.points;
  infinite[3].y() = INFINITY;
  EXPECT_TRUE(soup_from_bytes(to_bytes({soup, {soup.points}})));
  EXPECT_FALSE(soup_from_bytes(to_bytes({soup, {soup.points, fewer}})));
  EXPECT_FALSE(soup_from_bytes(to_bytes({soup, {soup.points, infinite}})));
}

TEST(SoupStream, RefusesACountThatWouldNotFit) {
  std::string bytes = to_bytes({separate_triangles(), {}});
  const std::uint64_t huge = ~std::uint64_t{0} / 8;
  std::memcpy(bytes.data(), &huge, sizeof huge);
  EXPECT_FALSE(soup_from_bytes(bytes));
}

}  // namespace
}  // namespace drape
