#include <gtest/gtest.h>

#include <numbers>

#include "contact/contact_geometry.h"
#include "contact/contact_step.h"
#include "scene.h"

namespace drape {
namespace {

using test::one_triangle;
using test::Scene;

constexpr PairKind point_triangle = PairKind::point_triangle, edge_edge = PairKind::edge_edge;

// Cloths of 4 and 6 mm, a mesh collider, a sphere of 0.3 m. The first cloth is two triangles, 1 mm apart at
// rest.
struct Bodies {
  Scene scene;
  int first, second, mesh, sphere;

  Bodies() {
    TriangleMesh cloth = one_triangle({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
    const TriangleMesh above = one_triangle({0.2, 0.001, 0.2}, {1, 3, 0}, {0, 3, 1});
    cloth.positions.insert(cloth.positions.end(), above.positions.begin(), above.positions.end());
    cloth.triangles.push_back({3, 4, 5});
    first = scene.add_cloth(cloth, 0.004, 0.2);
    second = scene.add_cloth(one_triangle({5, 0, 0}, {6, 0, 0}, {5, 0, 1}), 0.006, 0.8);
    mesh = scene.add_mesh(one_triangle({9, 0, 0}, {10, 0, 0}, {9, 0, 1}), 0.5);
    sphere = scene.add_sphere({0, 5, 0}, 0.3);
  }
  int vertex(int body) const { return scene.geometry.bodies[body].vertex_begin; }
  double thickness(const std::array<int, 4>& vertices, PairKind kind = point_triangle) const {
    return pair_thickness(scene.geometry, kind, vertices);
  }
};

TEST(ContactGeometry, TwoClothsKeepTheMeanOfTheirThicknesses) {
  const Bodies bodies;
  const int v = bodies.vertex(bodies.second);
  EXPECT_DOUBLE_EQ(bodies.thickness({v, 0, 1, 2}), 0.005);
  EXPECT_DOUBLE_EQ(bodies.thickness({0, 1, v, v + 1}, edge_edge), 0.005);
}

TEST(ContactGeometry, AClothKeepsItsThicknessFromACollider) {
  const Bodies bodies;
  const int v = bodies.vertex(bodies.mesh);
  EXPECT_DOUBLE_EQ(bodies.thickness({v, 0, 1, 2}), 0.004);
  EXPECT_DOUBLE_EQ(bodies.thickness({0, v, v + 1, v + 2}), 0.004);
}

TEST(ContactGeometry, ARoundedColliderAddsItsRadiusBesideTheThickness) {
  const Bodies bodies;
  EXPECT_DOUBLE_EQ(bodies.thickness({bodies.vertex(bodies.sphere), 0, 1, 2}), 0.004);
  EXPECT_DOUBLE_EQ(pair_radius(bodies.scene.geometry, bodies.sphere, bodies.first), 0.3);
  EXPECT_DOUBLE_EQ(pair_radius(bodies.scene.geometry, bodies.first, bodies.second), 0);
}

TEST(ContactGeometry, WithinAClothTheRestDistanceIsTheMost) {
  const Bodies bodies;
  EXPECT_NEAR(bodies.thickness({3, 0, 1, 2}), 2 / std::numbers::pi * 0.001, 1e-15);
  EXPECT_DOUBLE_EQ(bodies.thickness({4, 0, 1, 2}), 0.004);  // far apart at rest: the thickness
}

// Bent to half a turn of radius h / 2, two points that lie an arc of pi h / 2 apart at rest come h apart.
TEST(ContactGeometry, TheRestDistanceAllowsBendingToARadiusOfHalfTheThickness) {
  Scene scene;
  const double h = 0.01;
  scene.add_cloth(make_grid({1, 1}, {2, 2}), h);
  scene.geometry.rest_positions[3] = Vec3(0, 0, 0.5 * std::numbers::pi * h);
  scene.geometry.rest_positions[0] = Vec3(-1, 0, 0);
  scene.geometry.rest_positions[1] = Vec3(1, 0, 0);
  scene.geometry.rest_positions[2] = Vec3(0, 0, -1);
  EXPECT_NEAR(pair_thickness(scene.geometry, point_triangle, {3, 0, 1, 2}), h, 1e-15);
}

TEST(ContactGeometry, NoPairIsThickerThanTheLargest) {
  const Bodies bodies;
  const ContactGeometry& geometry = bodies.scene.geometry;
  for (const auto& [kind, vertices] : test::all_pairs(geometry)) {
    const auto [a, b] = pair_bodies(geometry, kind, vertices);
    EXPECT_LE(pair_thickness(geometry, kind, vertices), largest_thickness(geometry, a, b));
    EXPECT_EQ(largest_thickness(geometry, a, b), largest_thickness(geometry, b, a));
  }
}

// A bound tells it of most pairs: bit for bit what their closest points do.
TEST(ContactGeometry, WithinAClothTheThicknessFollowsFromTheDistanceAtRest) {
  constexpr double h = 0.01;
  test::Random random(1);
  Scene scene;
  TriangleMesh mesh = make_grid({0.1, 0.1}, {7, 7});
  for (Vec3& x : mesh.positions) x += random.vector(0.005);
  scene.add_cloth(mesh, h);
  int thinner = 0, full = 0;
  for (const auto& [kind, vertices] : test::all_pairs(scene.geometry)) {
    const double distance = closest_points(kind, gather(scene.geometry.rest_positions, vertices)).distance;
    const double thickness = pair_thickness(scene.geometry, kind, vertices);
    EXPECT_EQ(thickness, std::min(h, 2 / std::numbers::pi * distance));
    ++(thickness < h ? thinner : full);
  }
  EXPECT_GT(thinner, 100);
  EXPECT_GT(full, 100);
}

TEST(ContactGeometry, FrictionIsTheGeometricMean) {
  const Bodies bodies;
  const ContactGeometry& geometry = bodies.scene.geometry;
  EXPECT_DOUBLE_EQ(pair_friction(geometry, bodies.first, bodies.second), 0.4);
  EXPECT_DOUBLE_EQ(pair_friction(geometry, bodies.first, bodies.first), 0.2);
  EXPECT_EQ(pair_friction(geometry, bodies.first, bodies.sphere), 0);
}

TEST(ContactGeometry, ThePairsBodiesAreThoseOfItsSides) {
  const Bodies bodies;
  const int v = bodies.vertex(bodies.second);
  EXPECT_EQ(pair_bodies(bodies.scene.geometry, point_triangle, {0, v, v + 1, v + 2}),
            (std::array{bodies.first, bodies.second}));
  EXPECT_EQ(pair_bodies(bodies.scene.geometry, edge_edge, {v, v + 1, 0, 1}),
            (std::array{bodies.second, bodies.first}));
}

TEST(ContactSettings, FollowTheMeanEdge) {
  Scene scene;
  scene.add_cloth(one_triangle({0, 0, 0}, {3, 0, 0}, {0, 4, 0}), 0.002);
  scene.add_cloth(one_triangle({0, 0, 0}, {6, 0, 0}, {0, 8, 0}), 0.007);
  scene.add_mesh(one_triangle({0, 0, 0}, {600, 0, 0}, {0, 800, 0}));
  const ContactSettings settings = contact_settings(scene.geometry, 0.002);
  EXPECT_GT(settings.margins.least, 0);
  EXPECT_GT(settings.margins.most, settings.margins.least);
  EXPECT_LT(settings.margins.most, 6);
  EXPECT_GT(settings.margins.room, 0);
  EXPECT_EQ(settings.least_gap, 1e-5);
}

}  // namespace
}  // namespace drape
