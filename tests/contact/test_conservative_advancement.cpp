#include <gtest/gtest.h>

#include "contact/conservative_advancement.h"
#include "scene.h"

namespace drape {
namespace {

using test::Random;

constexpr PairKind both_kinds[] = {PairKind::point_triangle, PairKind::edge_edge};
constexpr double thickness = 0.05, tolerance = 0.001;

double distance_at(PairKind kind, const FourPoints& start, const FourPoints& end, double time) {
  return closest_points(kind, test::between(start, end, time)).distance;
}

// The first of `samples` + 1 times at which the sides are within `thickness`; 2 where there is none.
double sampled_time(PairKind kind, const FourPoints& start, const FourPoints& end, int samples) {
  for (int i = 0; i <= samples; ++i)
    if (distance_at(kind, start, end, i / double(samples)) <= thickness) return i / double(samples);
  return 2;
}

TEST(TimeOfContact, IsNeverLaterThanTheTruthAndNeverMissesAHit) {
  Random random(1);
  int hits = 0;
  for (int trial = 0; trial < 1500; ++trial)
    for (const PairKind kind : both_kinds) {
      const FourPoints start = random.four_points(), end = random.four_points();
      const double truth = sampled_time(kind, start, end, 400);
      if (truth > 1) continue;
      const auto time = time_of_contact(kind, start, end, thickness, tolerance);
      ASSERT_TRUE(time.has_value());
      ASSERT_LE(*time, truth + 1e-12);
      ++hits;
    }
  EXPECT_GT(hits, 300);
}

TEST(TimeOfContact, SidesThatMeetHeadOnAreWithinToleranceOfTheDistanceThen) {
  Random random(2);
  for (int trial = 0; trial < 500; ++trial) {
    const double from = random.between(0.1, 3);
    const FourPoints start = {Vec3(0.2, 0.2, from), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    FourPoints end = start;
    end[0] = Vec3(random.between(0, 0.5), random.between(0, 0.5), -random.between(0.1, 3));
    const auto time = time_of_contact(PairKind::point_triangle, start, end, thickness, tolerance);
    ASSERT_TRUE(time.has_value());
    ASSERT_LE(distance_at(PairKind::point_triangle, start, end, *time), thickness + tolerance + 1e-12);
  }
}

TEST(TimeOfContact, SidesHaveNotBeenNearerBefore) {
  Random random(3);
  for (int trial = 0; trial < 500; ++trial)
    for (const PairKind kind : both_kinds) {
      const FourPoints start = random.four_points(), end = random.four_points();
      const auto time = time_of_contact(kind, start, end, thickness, tolerance);
      if (!time || *time == 0) continue;
      for (int i = 0; i <= 100; ++i) ASSERT_GT(distance_at(kind, start, end, *time * i / 100.0), thickness);
    }
}

TEST(TimeOfContact, ThereIsNoneForSidesThatStayApart) {
  Random random(4);
  int apart = 0;
  for (int trial = 0; trial < 1500; ++trial)
    for (const PairKind kind : both_kinds) {
      const FourPoints start = random.four_points(), end = random.four_points();
      if (test::least_distance(kind, start, end, 400) < thickness + tolerance + 0.01) continue;
      ASSERT_FALSE(time_of_contact(kind, start, end, thickness, tolerance).has_value());
      ++apart;
    }
  EXPECT_GT(apart, 300);
}

TEST(TimeOfContact, APointThatShootsThroughATriangleIsCaught) {
  for (const double speed : {1.0, 1e3, 1e6}) {
    const FourPoints start = {Vec3(0.2, 0.2, 0.4 * speed), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    FourPoints end = start;
    end[0].z() = -0.6 * speed;
    const auto time = time_of_contact(PairKind::point_triangle, start, end, 1e-4, 1e-6);
    ASSERT_TRUE(time.has_value());
    EXPECT_LE(*time, 0.4);
    EXPECT_NEAR(*time, 0.4 - 1e-4 / speed, 2e-6);
  }
}

TEST(TimeOfContact, EdgesThatShootThroughEachOtherAreCaught) {
  const FourPoints start = {Vec3(-1, 0, 100), Vec3(1, 0, 100), Vec3(0, -1, 0), Vec3(0, 1, 0)};
  FourPoints end = start;
  end[0].z() = end[1].z() = -100;
  const auto time = time_of_contact(PairKind::edge_edge, start, end, 1e-4, 1e-6);
  ASSERT_TRUE(time.has_value());
  EXPECT_NEAR(*time, 0.5 - 1e-4 / 200, 1e-7);
}

TEST(TimeOfContact, ACommonMotionBringsNone) {
  Random random(5);
  for (const PairKind kind : both_kinds)
    for (const double distance : {1.0, 1e3, 1e6}) {
      const FourPoints start = {Vec3(0, 0, 0.1), Vec3(1, 0, 0.1), Vec3(0, 3, 0), Vec3(1, 3, 0)};
      FourPoints end = start;
      const Vec3 way = random.vector(distance);
      for (Vec3& x : end) x += way;
      EXPECT_FALSE(time_of_contact(kind, start, end, thickness, tolerance).has_value());
      EXPECT_NEAR(relative_motion(kind, start, end), 0, 1e-9 * distance);
    }
}

TEST(TimeOfContact, SidesThatAreNearAtOnceTouchAtTimeZero) {
  const FourPoints start = {Vec3(0.2, 0.2, 0.04), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  FourPoints end = start;
  end[0].z() = 5;  // though they part
  EXPECT_EQ(time_of_contact(PairKind::point_triangle, start, end, thickness, tolerance), 0.0);
  EXPECT_EQ(time_of_contact(PairKind::point_triangle, start, start, thickness, tolerance), 0.0);
}

TEST(TimeOfContact, SidesThatDoNotMoveAndAreApartNeverTouch) {
  const FourPoints x = {Vec3(0.2, 0.2, 0.4), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_FALSE(time_of_contact(PairKind::point_triangle, x, x, thickness, tolerance).has_value());
}

TEST(RelativeMotion, BoundsTheChangeOfTheDistance) {
  Random random(6);
  for (int trial = 0; trial < 5000; ++trial)
    for (const PairKind kind : both_kinds) {
      const FourPoints start = random.four_points(), end = random.four_points();
      const double bound = relative_motion(kind, start, end);
      const double before = distance_at(kind, start, end, 0);
      ASSERT_LE(std::abs(distance_at(kind, start, end, 0.6) - before), 0.6 * bound + 1e-12);
      ASSERT_LE(std::abs(distance_at(kind, start, end, 1) - before), bound + 1e-12);
    }
}

}  // namespace
}  // namespace drape
