#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/rigid_motion.h"

namespace drape {
namespace {

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LT((a - b).norm(), 1e-14) << a.transpose(); }

TEST(SinCosDegrees, NearTheStandardLibrarys) {
  for (int i = -36000; i <= 36000; ++i) {
    const double degrees = i * 0.0371;
    // In long double, so that turning degrees into radians costs nothing.
    const long double radians = degrees * (std::numbers::pi_v<long double> / 180);
    const auto [s, c] = sin_cos_degrees(degrees);
    EXPECT_NEAR(s, static_cast<double>(std::sin(radians)), 2.5e-16) << degrees;
    EXPECT_NEAR(c, static_cast<double>(std::cos(radians)), 2.5e-16) << degrees;
  }
}

TEST(SinCosDegrees, ExactAtQuarterTurns) {
  const std::pair<double, double> expected[4] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
  for (int quarter = -9; quarter <= 9; ++quarter)
    EXPECT_EQ(sin_cos_degrees(90.0 * quarter), expected[quarter & 3]);
}

TEST(SinCosDegrees, OfManyTurns) {
  const auto [s, c] = sin_cos_degrees(360.0 * 1000000 + 30);
  EXPECT_NEAR(s, 0.5, 1e-15);
  EXPECT_NEAR(c, std::sqrt(0.75), 1e-15);
}

TEST(Track, IsLinearBetweenKeysAndConstantOutside) {
  const Track track = {{1, 10}, {3, 20}, {4, 0}};
  EXPECT_EQ(sample(track, 0), 10);
  EXPECT_EQ(sample(track, 1), 10);
  EXPECT_EQ(sample(track, 1.5), 12.5);
  EXPECT_EQ(sample(track, 3), 20);
  EXPECT_EQ(sample(track, 3.75), 5);
  EXPECT_EQ(sample(track, 9), 0);
  EXPECT_EQ(sample({}, 9), 0);
  EXPECT_EQ(sample({{2, 7}}, 0), 7);
}

TEST(Rotation, AboutXThenYThenZ) {
  expect_near(rotation_from_degrees({90, 0, 0}) * Vec3::UnitY(), Vec3::UnitZ());
  expect_near(rotation_from_degrees({0, 90, 0}) * Vec3::UnitZ(), Vec3::UnitX());
  expect_near(rotation_from_degrees({0, 0, 90}) * Vec3::UnitX(), Vec3::UnitY());
  expect_near(rotation_from_degrees({90, 90, 0}) * Vec3::UnitY(), Vec3::UnitX());
}

TEST(Rotation, IsOrthonormal) {
  const Mat3 rotation = rotation_from_degrees({12, -34, 56});
  EXPECT_LT((rotation * rotation.transpose() - Mat3::Identity()).norm(), 1e-15);
  EXPECT_NEAR(rotation.determinant(), 1, 1e-15);
}

TEST(PoseAt, InterpolatesItsKeys) {
  RigidMotion motion;
  motion.at = {1, 2, 3};
  motion.translate[1] = {{0, 0}, {2, 4}};
  motion.turn[1] = {{0, 0}, {1, 90}};
  expect_near(pose_at(motion, 0)({0, 0, 1}), {1, 2, 4});
  expect_near(pose_at(motion, 1)({0, 0, 1}), {2, 4, 3});
  expect_near(pose_at(motion, 5)({0, 0, 1}), {2, 6, 3});
}

TEST(PoseAt, TurnsWhatIsPlaced) {
  RigidMotion motion;
  motion.rotate = {90, 0, 0};
  motion.turn[1] = {{0, 90}};
  expect_near(pose_at(motion, 0)(Vec3::UnitY()), Vec3::UnitX());
}

TEST(IsStatic, WhereNoTrackHasTwoKeys) {
  RigidMotion motion;
  EXPECT_TRUE(is_static(motion));
  motion.turn[0] = {{0, 90}};
  EXPECT_TRUE(is_static(motion));
  motion.translate[2] = {{0, 0}, {1, 1}};
  EXPECT_FALSE(is_static(motion));
}

TEST(MovesBetween, SeesWhatChangesOnTheWay) {
  RigidMotion motion;
  EXPECT_FALSE(moves_between(motion, 0, 1));
  motion.translate[1] = {{1.0, 2.0}, {2.0, 2.0}, {2.5, 3.0}, {3.0, 2.0}};
  EXPECT_FALSE(moves_between(motion, 0, 1.5));
  EXPECT_FALSE(moves_between(motion, 1.2, 2));
  EXPECT_TRUE(moves_between(motion, 1.9, 2.1));
  EXPECT_TRUE(moves_between(motion, 2, 3));  // there and back
  EXPECT_FALSE(moves_between(motion, 3, 9));
  motion.turn[2] = {{5.0, 0.0}, {6.0, 1.0}};
  EXPECT_TRUE(moves_between(motion, 3, 9));
}

TEST(NextKey, IsTheFirstOfAnyTrackAfterTheTime) {
  RigidMotion motion;
  const double none = std::numeric_limits<double>::infinity();
  EXPECT_EQ(next_key(motion, 0), none);
  motion.translate[1] = {{0.0, 0.0}, {2.0, 1.0}};
  motion.turn[0] = {{1.0, 0.0}, {1.5, 1.0}};
  EXPECT_EQ(next_key(motion, -1), 0);
  EXPECT_EQ(next_key(motion, 0), 1);
  EXPECT_EQ(next_key(motion, 1), 1.5);
  EXPECT_EQ(next_key(motion, 1.2), 1.5);
  EXPECT_EQ(next_key(motion, 1.5 - 1e-10), 2);  // a key that rounding puts ahead has been reached
  EXPECT_EQ(next_key(motion, 2), none);
}

TEST(LargestSpeed, IsThatOfTheSteepestPartOfTheTracks) {
  RigidMotion motion;
  EXPECT_EQ(largest_speed(motion), 0);
  motion.turn[0] = {{0.0, 0.0}, {1.0, 90.0}};
  EXPECT_EQ(largest_speed(motion), 0);
  motion.translate[0] = {{0.0, 0.0}, {1.0, 1.0}, {1.5, -1.0}};
  EXPECT_EQ(largest_speed(motion), 4);
  motion.translate[2] = {{3.0, 0.0}, {4.0, 3.0}};
  EXPECT_EQ(largest_speed(motion), 5);
}

}  // namespace
}  // namespace drape
