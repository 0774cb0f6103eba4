#include "certificate/solid.h"

#include <gtest/gtest.h>

#include <limits>

#include "mesh/primitives.h"

namespace drape {
namespace {

TrianglePoints small_triangle_at(const Vec3& p) { return {p, p + Vec3(0.01, 0, 0), p + Vec3(0, 0, 0.01)}; }

TEST(Solid, AHalfSpaceIsEnteredBelowItsPlane) {
  EXPECT_EQ(depth_in(HalfSpace{}, small_triangle_at({5, 0.001, 0})), 0);
  EXPECT_EQ(depth_in(HalfSpace{}, small_triangle_at({5, 0, 0})), 0);
  EXPECT_DOUBLE_EQ(depth_in(HalfSpace{}, small_triangle_at({5, -0.25, 0})), 0.25);
}

// Though all corners are outside.
TEST(Solid, ABallIsEnteredByTheMiddleOfATriangle) {
  const RoundedSegment ball{Vec3::Zero(), Vec3::Zero(), 1};
  const auto across = [](double y) { return TrianglePoints{Vec3(-9, y, -9), Vec3(9, y, -9), Vec3(0, y, 9)}; };
  EXPECT_DOUBLE_EQ(depth_in(ball, across(0.75)), 0.25);
  EXPECT_DOUBLE_EQ(depth_in(ball, across(0)), 1);
  EXPECT_EQ(depth_in(ball, across(1.5)), 0);
  EXPECT_EQ(depth_in(ball, small_triangle_at({0.8, 0.8, 0})), 0);
}

TEST(Solid, ACapsuleIsEnteredBesideItsSegment) {
  const RoundedSegment capsule{Vec3(0, -1, 0), Vec3(0, 1, 0), 0.5};
  EXPECT_NEAR(depth_in(capsule, small_triangle_at({0.375, 0.5, 0})), 0.125, 1e-15);
  EXPECT_NEAR(depth_in(capsule, small_triangle_at({0, 1.375, 0})), 0.125, 1e-15);
  EXPECT_EQ(depth_in(capsule, small_triangle_at({0.5, 1.375, 0})), 0);
}

TEST(Solid, ABoxAndACylinderAreLeftByTheNearestFace) {
  const ConvexSolid box = convex_solid(make_box({2, 1, 4}));
  EXPECT_NEAR(depth_in(box, {Vec3(0, 0.375, 0), Vec3(3, 3, 3), Vec3(9, 9, 9)}), 0.125, 1e-15);
  EXPECT_EQ(depth_in(box, small_triangle_at({0, 0.5, 0})), 0);
  EXPECT_EQ(depth_in(box, small_triangle_at({1.001, 0, 0})), 0);
  const ConvexSolid cylinder = convex_solid(make_cylinder(1, 4, 96));
  EXPECT_NEAR(depth_in(cylinder, {Vec3(0.75, 0, 0), Vec3(3, 3, 3), Vec3(9, 9, 9)}), 0.25, 1e-3);
  EXPECT_NEAR(depth_in(cylinder, {Vec3(0, 1.9, 0), Vec3(3, 3, 3), Vec3(9, 9, 9)}), 0.1, 1e-15);
}

TEST(Solid, IsNotEnteredByWhatIsNowhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(depth_in(HalfSpace{}, small_triangle_at({nan, -1, 0})), 0);
}

}  // namespace
}  // namespace drape
