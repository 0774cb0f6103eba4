#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/rigid_motion.h"
#include "mesh/primitives.h"
#include "mesh/shadow.h"

namespace drape {
namespace {

using std::numbers::pi;

TriangleMesh moved(TriangleMesh mesh, const Vec3& rotate, const Vec3& at) {
  const Mat3 rotation = rotation_from_degrees(rotate);
  for (Vec3& p : mesh.positions) p = rotation * p + at;
  return mesh;
}

double area_of(const TriangleMesh& mesh) { return shadow_area(mesh.positions, mesh.triangles); }

TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const int first = int(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return a;
}

// 0.1 percentage points of the ring of a drape test are 4.5e-5 m2. Edges that lie along the lines cost most.
constexpr double along_lines = 1e-5;
constexpr double elsewhere = 1e-6;

TEST(ShadowArea, IsThatOfAFlatPiece) {
  EXPECT_NEAR(area_of(make_grid({0.3, 0.2}, {7, 5})), 0.06, 1e-12);
  EXPECT_NEAR(area_of(moved(make_grid({0.3, 0.2}, {7, 5}), {0, 33, 0}, {1, 2, 3})), 0.06, elsewhere);
  const double polygon = 0.5 * 188 * 0.15 * 0.15 * std::sin(2 * pi / 188);
  EXPECT_NEAR(area_of(make_disc(0.3, 0.005)), polygon, elsewhere);
}

TEST(ShadowArea, ShrinksWithTheTilt) {
  EXPECT_NEAR(area_of(moved(make_grid({0.3, 0.2}, {7, 5}), {60, 0, 0}, Vec3::Zero())), 0.03, elsewhere);
  EXPECT_NEAR(area_of(moved(make_grid({0.3, 0.2}, {7, 5}), {90, 0, 0}, Vec3::Zero())), 0, elsewhere);
}

TEST(ShadowArea, TheBackThrowsTheSame) {
  EXPECT_NEAR(area_of(moved(make_grid({0.3, 0.2}, {7, 5}), {180, 0, 0}, Vec3::Zero())), 0.06, 1e-12);
}

TEST(ShadowArea, CountsOnceWhatLiesOverEachOther) {
  const TriangleMesh square = make_grid({0.2, 0.2}, {4, 4});
  EXPECT_NEAR(area_of(together(square, moved(square, Vec3::Zero(), {0, 1, 0}))), 0.04, 1e-12);
  EXPECT_NEAR(area_of(together(square, moved(square, Vec3::Zero(), {0.05, 1, 0.1}))), 0.08 - 0.015,
              along_lines);
  EXPECT_NEAR(area_of(make_sphere(0.1, 64, 32)), 0.5 * 64 * 0.01 * std::sin(2 * pi / 64), elsewhere);
}

TEST(SurfaceArea, IsTheSameHoweverThePieceHangs) {
  const TriangleMesh hung = moved(make_grid({0.3, 0.2}, {7, 5}), {50, 10, 3}, {1, 2, 3});
  EXPECT_NEAR(surface_area(hung.positions, hung.triangles), 0.06, 1e-15);
}

TEST(ShadowArea, IsNothingForNothing) {
  EXPECT_EQ(shadow_area({}, {}), 0);
  EXPECT_EQ(shadow_area({Vec3::Zero(), Vec3::UnitX(), Vec3::UnitX()}, {{0, 1, 2}}), 0);
}

TEST(ShadowOutline, OfADiscIsItsRadiusRoundItsCentre) {
  const Vec3 at(0.4, 3, -0.2);
  const TriangleMesh disc = moved(make_disc(0.3, 0.01), Vec3::Zero(), at);
  for (const double r : shadow_outline(disc.positions, disc.triangles, at, 90)) EXPECT_NEAR(r, 0.15, 1e-4);
}

TEST(ShadowOutline, GoesFromXTowardsMinusZ) {
  const TriangleMesh grid = moved(make_grid({0.4, 0.2}, {3, 3}), Vec3::Zero(), {0, 0, -0.05});
  const auto outline = shadow_outline(grid.positions, grid.triangles, Vec3::Zero(), 4);
  const double expected[] = {0.2, 0.15, 0.2, 0.05};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(outline[i], expected[i], 1e-12);
}

TEST(ShadowOutline, IsNoughtWhereThereIsNoShadow) {
  const TriangleMesh grid = moved(make_grid({0.2, 0.2}, {3, 3}), Vec3::Zero(), {1, 0, 0});
  const auto outline = shadow_outline(grid.positions, grid.triangles, Vec3::Zero(), 4);
  EXPECT_NEAR(outline[0], 1.1, 1e-12);
  EXPECT_EQ(outline[2], 0);
}

// r = r0 + a cos(n phi), metres.
std::vector<double> waves(int n, double a, double roughness = 0) {
  std::vector<double> curve;
  for (int i = 0; i < 720; ++i)
    curve.push_back(0.12 + a * std::cos(n * i * pi / 360 + 1) + roughness * std::cos(97 * i * pi / 360));
  return curve;
}

TEST(CountMaxima, CountsTheWavesOfACosine) {
  for (int n = 1; n <= 12; ++n) EXPECT_EQ(count_maxima(waves(n, 0.01), 0.002), n);
}

TEST(CountMaxima, TakesWhatIsLowForRoughness) {
  EXPECT_EQ(count_maxima(waves(6, 0.01, 0.0009), 0.002), 6);
  EXPECT_EQ(count_maxima(waves(6, 0.0009), 0.002), 0);
  EXPECT_EQ(count_maxima(std::vector<double>(720, 0.15), 0.002), 0);
  EXPECT_EQ(count_maxima({}, 0.002), 0);
}

TEST(CountMaxima, HoldsAMaximumAgainstTheHigherOfItsMinima) {
  EXPECT_EQ(count_maxima({0, 5, 4, 6}, 2), 1);
  EXPECT_EQ(count_maxima({0, 5, 3, 6}, 2), 2);
  EXPECT_EQ(count_maxima({5, 3, 6, 0}, 2), 2);
}

}  // namespace
}  // namespace drape
