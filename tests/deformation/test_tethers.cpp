#include <gtest/gtest.h>

#include <algorithm>

#include "deformation/tethers.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;
using test::sheet_of;

constexpr double gravity = 9.81;

TetherStage tethers_of(const Sheet& sheet, const std::vector<int>& pins, double g) {
  std::vector<char> pinned(sheet.rest_positions.size(), 0);
  for (const int v : pins) pinned[v] = 1;
  return build_tethers(sheet, lumped_masses(sheet), pinned, g);
}

std::vector<Vec3> pulled(const TetherStage& stage, const std::vector<Vec3>& start,
                         const std::vector<Vec3>& ways) {
  std::vector<Point4> base, offsets = test::points_of(ways, std::vector<double>(ways.size(), 1));
  load_tethers(stage, test::split_of(start), base);
  pull_tethers(stage, base, offsets);
  return test::sum_of(start, test::vectors_of(offsets, ways.size()));
}

double farthest_beyond(const TetherStage& stage, const std::vector<Vec3>& x) {
  double beyond = 0;
  for (const Tether& tether : stage.tethers)
    beyond = std::max(beyond, (x[tether.vertex] - x[tether.pin]).norm() - static_cast<double>(tether.length));
  return beyond;
}

const Tether& tether_of(const TetherStage& stage, int vertex) {
  return *std::find_if(stage.tethers.begin(), stage.tethers.end(),
                       [&](const Tether& tether) { return tether.vertex == vertex; });
}

TEST(Tethers, NoPointEndsFartherThanItsTether) {
  Random random(1);
  const Sheet sheet = sheet_of(make_grid({1, 1}, {9, 9}));
  const TetherStage stage = tethers_of(sheet, {0, 1, 2}, gravity);
  std::vector<Vec3> ways = test::shaken(test::zeros(81), 1, random);
  for (const int pin : {0, 1, 2}) ways[pin].setZero();
  ASSERT_GT(farthest_beyond(stage, test::sum_of(sheet.rest_positions, ways)), 0.3);
  EXPECT_LT(farthest_beyond(stage, pulled(stage, sheet.rest_positions, ways)), 1e-6);
}

// Of several groups only the nearest: so pins that are drawn apart do not fight over a point.
TEST(Tethers, PinsDrawnApartLeaveNoPointBeyondItsTether) {
  const Sheet sheet = sheet_of(make_grid({1, 1}, {9, 9}));
  const TetherStage stage = tethers_of(sheet, {0, 8, 72}, gravity);
  std::vector<Vec3> x = sheet.rest_positions;
  for (const int pin : {0, 8, 72}) x[pin] *= 1.5;
  ASSERT_GT(farthest_beyond(stage, x), 0.1);
  EXPECT_LT(farthest_beyond(stage, pulled(stage, x, test::zeros(81))), 1e-6);
}

TEST(Tethers, PointsWithinTheirTethersAndPinsStay) {
  const Sheet sheet = sheet_of(make_grid({1, 1}, {9, 9}));
  const TetherStage stage = tethers_of(sheet, {0, 8}, gravity);
  const std::vector<Vec3> folded = test::moved(sheet.rest_positions, 0.9 * Mat3::Identity(), Vec3::Zero());
  EXPECT_EQ(pulled(stage, folded, test::zeros(81)), folded);
  for (const Tether& tether : stage.tethers) EXPECT_TRUE(tether.vertex != 0 && tether.vertex != 8);
}

TEST(Tethers, EachPointHasOneToTheNearestPinOfTheNearestGroup) {
  const Sheet sheet = sheet_of(make_grid({1, 1}, {9, 9}));
  const TetherStage stage = tethers_of(sheet, {0, 1, 2, 80}, gravity);
  EXPECT_EQ(stage.tethers.size(), 77u);
  EXPECT_EQ(tether_of(stage, 79).pin, 80);
  EXPECT_EQ(tether_of(stage, 4).pin, 2);
  EXPECT_EQ(tether_of(stage, 9).pin, 0);
}

TEST(Tethers, WithoutWeightTheyAreAsLongAsTheStraightWay) {
  const Sheet sheet = sheet_of(make_grid({1, 1}, {9, 9}));
  for (const Tether& tether : tethers_of(sheet, {40}, 0).tethers)
    EXPECT_NEAR(tether.length, (sheet.rest_positions[tether.vertex] - sheet.rest_positions[40]).norm(), 1e-6);
}

TEST(Tethers, WithoutPinsThereAreNone) {
  const Sheet sheet = sheet_of(make_grid({1, 1}, {5, 5}));
  const TetherStage stage = tethers_of(sheet, {}, gravity);
  EXPECT_TRUE(stage.tethers.empty());
  const std::vector<Vec3> ways(25, Vec3(9, 9, 9));
  EXPECT_EQ(pulled(stage, sheet.rest_positions, ways), test::sum_of(sheet.rest_positions, ways));
}

TriangleMesh two_pieces() {
  TriangleMesh mesh = make_grid({1, 1}, {4, 4});
  const TriangleMesh other = make_grid({1, 1}, {4, 4});
  for (const Vec3& x : other.positions) mesh.positions.push_back(x + Vec3(5, 0, 0));
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + 16, b + 16, c + 16});
  return mesh;
}

TEST(Tethers, APieceWithoutPinsHasNone) {
  const TetherStage stage = tethers_of(sheet_of(two_pieces()), {3}, gravity);
  EXPECT_EQ(stage.tethers.size(), 15u);
  for (const Tether& tether : stage.tethers) EXPECT_LT(tether.vertex, 16);
}

// A grid of 9 x 9 points without the quarter at the far end of both its sides.
TriangleMesh l_shape() {
  const TriangleMesh grid = make_grid({1, 1}, {9, 9});
  std::vector<int> number(81, -1);
  TriangleMesh mesh;
  for (const Triangle& triangle : grid.triangles) {
    const Vec3 sum = grid.positions[triangle[0]] + grid.positions[triangle[1]] + grid.positions[triangle[2]];
    if (sum.x() > 0 && sum.z() > 0) continue;
    Triangle own;
    for (int k = 0; k < 3; ++k) {
      int& n = number[triangle[k]];
      if (n < 0) {
        n = static_cast<int>(mesh.positions.size());
        mesh.positions.push_back(grid.positions[triangle[k]]);
      }
      own[k] = n;
    }
    mesh.triangles.push_back(own);
  }
  return mesh;
}

int vertex_at(const TriangleMesh& mesh, const Vec3& x) {
  const auto closer = [&](const Vec3& a, const Vec3& b) { return (a - x).norm() < (b - x).norm(); };
  return static_cast<int>(std::min_element(mesh.positions.begin(), mesh.positions.end(), closer) -
                          mesh.positions.begin());
}

// From the end of one leg to that of the other the way leads round the inner corner, along edges.
TEST(Tethers, APieceThatIsNotConvexHasItsWaysWithin) {
  const TriangleMesh mesh = l_shape();
  const int pin = vertex_at(mesh, {0.5, 0, 0}), end = vertex_at(mesh, {0, 0, 0.5});
  const double length = tether_of(tethers_of(sheet_of(mesh), {pin}, 0), end).length;
  EXPECT_NEAR(length, 1, 1e-6);
  EXPECT_GT(length, (mesh.positions[pin] - mesh.positions[end]).norm() + 0.2);
}

TEST(Tethers, ACurvedPieceHasItsWaysAlongItsSurface) {
  const TriangleMesh mesh = make_sphere(1, 24, 13);
  const int top = vertex_at(mesh, {0, 1, 0}), bottom = vertex_at(mesh, {0, -1, 0});
  const double length = tether_of(tethers_of(sheet_of(mesh), {top}, 0), bottom).length;
  EXPECT_GT(length, 3.0);
  EXPECT_LT(length, 3.15);
}

// Under its own weight a strip of length L stretches by density g L2 / (2 k) at its end, and less above.
TEST(Tethers, AHangingStripHasTheSlackThatItsStiffnessAsksFor) {
  for (const double width : {1.0, 0.3, 0.05})
    for (const double stiffness : {20.0, 200.0, 20000.0}) {
      ElasticMaterial material;
      material.stretch_stiffness = {stiffness, stiffness};
      const TriangleMesh mesh = make_grid({width, 1}, {5, 21});
      const double strain = material.density * gravity / stiffness;
      for (const Tether& tether : tethers_of(sheet_of(mesh, material), {0, 1, 2, 3, 4}, gravity).tethers) {
        const double way = mesh.positions[tether.vertex].z() - mesh.positions[0].z();
        EXPECT_GT(tether.length, way + strain * (way - 0.5 * way * way) - 1e-6) << width << " " << stiffness;
      }
    }
}

TEST(Tethers, StiffClothHasLittleSlack) {
  const TriangleMesh mesh = make_grid({1, 1}, {21, 21});
  for (const Tether& tether : tethers_of(sheet_of(mesh), {0, 20}, gravity).tethers)
    EXPECT_LT(tether.length, (mesh.positions[tether.vertex] - mesh.positions[tether.pin]).norm() + 0.001);
}

}  // namespace
}  // namespace drape
