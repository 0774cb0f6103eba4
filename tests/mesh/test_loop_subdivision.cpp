#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/loop_subdivision.h"
#include "mesh/primitives.h"
#include "mesh/topology.h"

namespace drape {
namespace {

std::vector<Vec3f> as_floats(const std::vector<Vec3>& positions) {
  std::vector<Vec3f> floats;
  for (const Vec3& p : positions) floats.push_back(p.cast<float>());
  return floats;
}

// What a point of the coarse mesh contributes to each refined point.
std::vector<float> influence(const LoopSubdivision& loop, std::size_t count, int point) {
  std::vector<Vec3f> unit(count, Vec3f::Zero());
  unit[point].x() = 1;
  std::vector<float> weights;
  for (const Vec3f& p : loop.apply(unit)) weights.push_back(p.x());
  return weights;
}

int count_near(const std::vector<float>& values, float value) {
  return static_cast<int>(
      std::count_if(values.begin(), values.end(), [&](float x) { return std::abs(x - value) < 1e-6f; }));
}

TEST(LoopSubdivision, LevelZeroIsTheMesh) {
  const TriangleMesh mesh = make_grid({1, 1}, {4, 5});
  const LoopSubdivision loop(mesh, 0);
  EXPECT_EQ(loop.triangles(), mesh.triangles);
  EXPECT_EQ(loop.uv_triangles(), mesh.uv_triangles);
  EXPECT_EQ(loop.uvs().size(), mesh.uvs.size());
  EXPECT_EQ(loop.apply(as_floats(mesh.positions)), as_floats(mesh.positions));
}

TEST(LoopSubdivision, FourTimesTheTrianglesALevel) {
  const TriangleMesh mesh = make_grid({1, 1}, {5, 4});
  for (int level = 0; level <= 4; ++level) {
    const LoopSubdivision loop(mesh, level);
    EXPECT_EQ(loop.triangles().size(), mesh.triangles.size() << (2 * level));
    EXPECT_EQ(loop.uv_triangles().size(), loop.triangles().size());
  }
}

TEST(LoopSubdivision, FlatStaysFlatAndFrontUp) {
  const TriangleMesh mesh = make_grid({2, 1}, {5, 4});
  const LoopSubdivision loop(mesh, 2);
  const auto positions = loop.apply(as_floats(mesh.positions));
  for (const Vec3f& p : positions) {
    EXPECT_EQ(p.y(), 0);
    EXPECT_LE(std::abs(p.x()), 1.000001f);
  }
  for (const Vec3f& n : vertex_normals(positions, loop.triangles()))
    EXPECT_NEAR((n - Vec3f::UnitY()).norm(), 0, 1e-6);
}

// The point 12 is in the middle of a grid of 5 x 5 points: it and its neighbours have six neighbours.
TEST(LoopSubdivision, WeightsOfTheRegularCase) {
  const TriangleMesh mesh = make_grid({4, 4}, {5, 5});
  const LoopSubdivision loop(mesh, 1);
  const auto weights = influence(loop, mesh.positions.size(), 12);
  EXPECT_EQ(count_near(weights, 5.f / 8), 1);   // itself
  EXPECT_EQ(count_near(weights, 3.f / 8), 6);   // the middles of its edges
  EXPECT_EQ(count_near(weights, 1.f / 16), 6);  // its neighbours
  EXPECT_EQ(count_near(weights, 1.f / 8), 6);   // the middles of the edges across from it
  EXPECT_EQ(count_near(weights, 0), int(weights.size()) - 19);
}

TEST(LoopSubdivision, WeightsOfTheBoundary) {
  const TriangleMesh mesh = make_grid({4, 4}, {5, 5});
  const LoopSubdivision loop(mesh, 1);
  const auto fine = loop.apply(as_floats(mesh.positions));
  const auto weights = influence(loop, mesh.positions.size(), 2);  // the middle of the side z = -2
  for (std::size_t i = 0; i < fine.size(); ++i) {
    if (fine[i].z() != -2) continue;
    const float distance = std::abs(fine[i].x());
    const float expected = distance == 0 ? 0.75f : distance == 0.5f ? 0.5f : distance == 1 ? 0.125f : 0.f;
    EXPECT_EQ(weights[i], expected);
  }
}

TEST(LoopSubdivision, CornersStaySharp) {
  const TriangleMesh mesh = make_grid({2, 2}, {4, 4});
  const auto fine = LoopSubdivision(mesh, 3).apply(as_floats(mesh.positions));
  for (const Vec3f& corner : {Vec3f(-1, 0, -1), Vec3f(1, 0, -1), Vec3f(-1, 0, 1), Vec3f(1, 0, 1)})
    EXPECT_EQ(std::count(fine.begin(), fine.end(), corner), 1);
}

// Twelve sides turn by 30 degrees each: no corners.
TEST(LoopSubdivision, ARoundSheetStaysRound) {
  TriangleMesh mesh{{{0, 0, 0}}, {}, {}, {}};
  for (int i = 0; i < 12; ++i) {
    mesh.positions.emplace_back(std::cos(i * 0.5235987755982988), 0, -std::sin(i * 0.5235987755982988));
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % 12});
  }
  for (const Vec3f& p : LoopSubdivision(mesh, 1).apply(as_floats(mesh.positions))) EXPECT_LT(p.norm(), 0.99f);
}

TEST(LoopSubdivision, TextureCoordinatesAreRefinedLinearly) {
  const TriangleMesh mesh = make_grid({1, 1}, {3, 3});
  const LoopSubdivision loop(mesh, 2);
  // Linear refinement of a square of 2 x 2 cells: a grid of 9 x 9 values at eighths.
  ASSERT_EQ(loop.uvs().size(), 81u);
  for (const Vec2f& uv : loop.uvs()) {
    EXPECT_EQ(uv.x() * 8, std::round(uv.x() * 8));
    EXPECT_EQ(uv.y() * 8, std::round(uv.y() * 8));
  }
  for (const Triangle& t : loop.uv_triangles()) {
    const Vec2f a = loop.uvs()[t[1]] - loop.uvs()[t[0]], b = loop.uvs()[t[2]] - loop.uvs()[t[0]];
    EXPECT_FLOAT_EQ(std::abs(a.x() * b.y() - a.y() * b.x()), 1.f / 64);
  }
}

TEST(LoopSubdivision, SeamsOfTheTextureStay) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                          {{0, 1, 2}, {2, 1, 3}},
                          {{0, 0}, {0.25, 0}, {0, 1}, {0.5, 1}, {0.75, 0}, {1, 1}},
                          {{0, 1, 2}, {3, 4, 5}}};
  const LoopSubdivision loop(mesh, 1);
  EXPECT_EQ(loop.apply(as_floats(mesh.positions)).size(), 9u);
  EXPECT_EQ(loop.uvs().size(), 12u);
}

TriangleMesh icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  return {{{-1, g, 0},
           {1, g, 0},
           {-1, -g, 0},
           {1, -g, 0},
           {0, -1, g},
           {0, 1, g},
           {0, -1, -g},
           {0, 1, -g},
           {g, 0, -1},
           {g, 0, 1},
           {-g, 0, -1},
           {-g, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}},
          {},
          {}};
}

TEST(LoopSubdivision, ClosedStaysClosed) {
  const TriangleMesh mesh = icosahedron();
  const LoopSubdivision loop(mesh, 3);
  const auto fine = loop.apply(as_floats(mesh.positions));
  const Topology topology = build_topology(static_cast<int>(fine.size()), loop.triangles());
  EXPECT_EQ(fine.size() + loop.triangles().size() - topology.edges.size(), 2u);
  for (const Edge& edge : topology.edges) EXPECT_GE(edge.triangles[1], 0);
  EXPECT_TRUE(loop.uvs().empty() && loop.uv_triangles().empty());
}

TEST(LoopSubdivision, ManyPointsGiveTheSameBitsAsFew) {
  const TriangleMesh mesh = make_grid({1, 1}, {78, 78});
  const LoopSubdivision loop(mesh, 2);
  EXPECT_EQ(loop.apply(as_floats(mesh.positions)), loop.apply(as_floats(mesh.positions)));
}

TEST(VertexNormals, OfASphereAreRadial) {
  const TriangleMesh mesh = make_sphere(2, 24, 12);
  const auto positions = as_floats(mesh.positions);
  const auto normals = vertex_normals(positions, mesh.triangles);
  for (std::size_t i = 0; i < normals.size(); ++i)
    EXPECT_NEAR((normals[i] - positions[i] / 2).norm(), 0, 1e-5);
}

TEST(VertexNormals, WithoutATriangleThereIsStillOne) {
  const auto normals = vertex_normals({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 0, 1}});
  for (const Vec3f& n : normals) EXPECT_EQ(n, Vec3f(0, 1, 0));
}

// Each triangle becomes four for a level, and none of their corners leaves its plane.
TEST(LoopSubdivision, FlatPointsLieInTheCoarseTriangles) {
  TriangleMesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 1)};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  const LoopSubdivision subdivision(mesh, 2);
  std::vector<Vec3f> coarse;
  for (const Vec3& p : mesh.positions) coarse.push_back(p.cast<float>());
  const std::vector<Vec3f> flat = subdivision.apply_flat(coarse), smooth = subdivision.apply(coarse);
  ASSERT_EQ(flat.size(), smooth.size());
  ASSERT_EQ(flat.size(), 25u);
  for (const Vec3f& p : flat) {
    const float beyond_fold =
        p.x() + p.y() - 1;  // x + y = 1 is the edge that both share; beyond it z = x + y - 1
    EXPECT_NEAR(p.z(), std::max(0.0f, beyond_fold), 1e-6f) << p.transpose();
  }
  double area = 0;
  for (const auto& [a, b, c] : subdivision.triangles())
    area += 0.5 * (flat[b] - flat[a]).cross(flat[c] - flat[a]).norm();
  EXPECT_NEAR(area, 0.5 + 0.5 * std::sqrt(3.0), 1e-6);
}

}  // namespace
}  // namespace drape
