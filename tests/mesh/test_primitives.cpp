#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/manifold.h"
#include "mesh/measure.h"
#include "mesh/primitives.h"
#include "mesh/topology.h"

namespace drape {
namespace {

using std::numbers::pi;
using test::area;
using test::volume;

void expect_closed(const TriangleMesh& mesh) {
  EXPECT_EQ(check_manifold(mesh), std::vector<std::string>{});
  for (const Edge& edge : build_topology(int(mesh.positions.size()), mesh.triangles).edges)
    EXPECT_GE(edge.triangles[1], 0);
}

TEST(Grid, Counts) {
  const TriangleMesh mesh = make_grid({1, 1}, {78, 78});
  EXPECT_EQ(mesh.positions.size(), 6084u);
  EXPECT_EQ(mesh.triangles.size(), 11858u);
  EXPECT_EQ(check_manifold(mesh), std::vector<std::string>{});
}

TEST(Grid, LiesFlatWithItsFrontUp) {
  const TriangleMesh mesh = make_grid({3, 2}, {4, 9});
  EXPECT_EQ(mesh.positions.front(), Vec3(-1.5, 0, -1));
  EXPECT_EQ(mesh.positions.back(), Vec3(1.5, 0, 1));
  EXPECT_NEAR(area(mesh), 6, 1e-12);
  for (const Triangle& t : mesh.triangles) EXPECT_GT(test::area_vector(mesh, t).y(), 0);
}

TEST(Grid, RowsRunAlongX) {
  const TriangleMesh mesh = make_grid({1, 1}, {3, 2});
  EXPECT_GT(mesh.positions[1].x(), mesh.positions[0].x());
  EXPECT_EQ(mesh.positions[1].z(), mesh.positions[0].z());
  EXPECT_EQ(mesh.uvs[1], Vec2(0.5, 0));
  EXPECT_EQ(mesh.uvs[5], Vec2(1, 1));
  EXPECT_EQ(mesh.uv_triangles, mesh.triangles);
}

// A coarse disc, one that scenes have, and a fine one: metres, and where the area of a circle is reached to.
struct DiscSize {
  double edge;
  double area_tolerance;  // of the circle's area: what the boundary's chords cut off
};

class Disc : public testing::TestWithParam<DiscSize> {
 protected:
  static constexpr double diameter = 0.3;
  TriangleMesh mesh = make_disc(diameter, GetParam().edge);
  Topology topology = build_topology(int(mesh.positions.size()), mesh.triangles);
};

TEST_P(Disc, IsOnePieceWithoutHoles) {
  EXPECT_EQ(check_manifold(mesh), std::vector<std::string>{});
  const auto euler = std::ptrdiff_t(mesh.positions.size() + mesh.triangles.size() - topology.edges.size());
  EXPECT_EQ(euler, 1);
}

TEST_P(Disc, LiesFlatWithItsFrontUpAndTheAreaOfTheCircle) {
  for (const Triangle& t : mesh.triangles) EXPECT_GT(test::area_vector(mesh, t).y(), 0);
  const double circle = pi * diameter * diameter / 4;
  EXPECT_LT(area(mesh), circle);
  EXPECT_GT(area(mesh), (1 - GetParam().area_tolerance) * circle);
}

TEST_P(Disc, ItsBoundaryIsTheCircle) {
  for (const Edge& edge : topology.edges) {
    if (edge.triangles[1] >= 0) continue;
    for (const int vertex : edge.vertices) EXPECT_NEAR(mesh.positions[vertex].norm(), diameter / 2, 1e-15);
  }
}

TEST_P(Disc, ItsEdgesAreOfNearlyOneLength) {
  for (const Edge& edge : topology.edges) {
    const double length = (mesh.positions[edge.vertices[0]] - mesh.positions[edge.vertices[1]]).norm();
    EXPECT_GT(length, 0.75 * GetParam().edge);
    EXPECT_LT(length, 1.4 * GetParam().edge);
  }
}

TEST_P(Disc, ItsPointsAreCountedBefore) {
  EXPECT_NEAR(count_disc_points(diameter, GetParam().edge), double(mesh.positions.size()),
              0.06 * double(mesh.positions.size()));
}

TEST_P(Disc, ItsTextureIsItsPlan) {
  EXPECT_EQ(mesh.uvs.front(), Vec2(0.5, 0.5));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_NEAR((Vec2(mesh.positions[i].x(), mesh.positions[i].z()) / diameter - mesh.uvs[i]).x(), -0.5,
                1e-15);
  EXPECT_EQ(mesh.uv_triangles, mesh.triangles);
}

INSTANTIATE_TEST_SUITE_P(Edges, Disc,
                         testing::Values(DiscSize{0.03, 0.01}, DiscSize{0.005, 2e-4}, DiscSize{0.002, 4e-5}));

TEST(CoarsestDisc, IsOnePieceToo) {
  const TriangleMesh mesh = make_disc(1, 0.25);
  EXPECT_EQ(check_manifold(mesh), std::vector<std::string>{});
  EXPECT_GT(area(mesh), 0.9 * pi / 4);
}

TEST(Cylinder, ClosedAndOutward) {
  const TriangleMesh mesh = make_cylinder(0.5, 3, 96);
  expect_closed(mesh);
  EXPECT_EQ(mesh.positions.size(), 2 * 96 + 2u);
  const double base = 0.5 * 96 * 0.25 * std::sin(2 * pi / 96);
  EXPECT_NEAR(volume(mesh), 3 * base, 1e-12);
  EXPECT_NEAR(area(mesh), 2 * base + 3 * 96 * std::sin(pi / 96), 1e-12);
}

TEST(Cylinder, StandsAlongYWithFlatEnds) {
  for (const Vec3& p : make_cylinder(2, 1, 5).positions) {
    EXPECT_EQ(std::abs(p.y()), 0.5);
    const double from_axis = std::hypot(p.x(), p.z());
    EXPECT_NEAR(from_axis, from_axis > 0 ? 2 : 0, 1e-14);
  }
}

TEST(Box, ClosedAndOutward) {
  const TriangleMesh mesh = make_box({1, 2, 3});
  expect_closed(mesh);
  EXPECT_EQ(mesh.positions.size(), 8u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_NEAR(volume(mesh), 6, 1e-12);
  EXPECT_NEAR(area(mesh), 22, 1e-12);
  for (const Triangle& t : mesh.triangles) EXPECT_GT(test::area_vector(mesh, t).dot(mesh.positions[t[0]]), 0);
}

TEST(Sphere, ClosedAndOutward) {
  const TriangleMesh mesh = make_sphere(2, 64, 32);
  expect_closed(mesh);
  for (const Vec3& p : mesh.positions) EXPECT_NEAR(p.norm(), 2, 1e-14);
  EXPECT_LT(volume(mesh), 32 * pi / 3);
  EXPECT_GT(volume(mesh), 0.99 * 32 * pi / 3);
  EXPECT_LT(area(mesh), 16 * pi);
  EXPECT_GT(area(mesh), 0.99 * 16 * pi);
  expect_closed(make_sphere(1, 3, 2));
}

TEST(Capsule, ClosedAndOutward) {
  const Vec3 a(1, 2, 3), b(2, 4, 5);  // 3 apart
  const TriangleMesh mesh = make_capsule(a, b, 0.5, 48, 16);
  expect_closed(mesh);
  const double exact_volume = 3 * pi * 0.25 + 4 * pi / 3 * 0.125;
  EXPECT_LT(volume(mesh), exact_volume);
  EXPECT_GT(volume(mesh), 0.98 * exact_volume);
  const double exact_area = 2 * pi * 0.5 * 3 + 4 * pi * 0.25;
  EXPECT_LT(area(mesh), exact_area);
  EXPECT_GT(area(mesh), 0.98 * exact_area);
}

TEST(Capsule, EveryPointIsOneRadiusFromTheSegment) {
  const Vec3 a(0, -1, 0), b(0, 1, 0);
  for (const Vec3& p : make_capsule(a, b, 0.5, 12, 4).positions)
    EXPECT_NEAR((p - Vec3(0, std::clamp(p.y(), -1.0, 1.0), 0)).norm(), 0.5, 1e-14);
}

TEST(Capsule, WithoutLengthIsASphere) {
  const TriangleMesh mesh = make_capsule({1, 1, 1}, {1, 1, 1}, 0.5, 32, 8);
  expect_closed(mesh);
  for (const Vec3& p : mesh.positions) EXPECT_NEAR((p - Vec3(1, 1, 1)).norm(), 0.5, 1e-14);
}

}  // namespace
}  // namespace drape
