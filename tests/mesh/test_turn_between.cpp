#include "mesh/turn_between.h"

#include <gtest/gtest.h>

#include <numbers>

namespace drape {
namespace {

Quaternion about(const Vec3& axis, double angle) {
  return Quaternion(Eigen::AngleAxisd(angle, axis.normalized()));
}

double distance(const Quaternion& a, const Quaternion& b) { return (a.coeffs() - b.coeffs()).norm(); }

TEST(TurnBetween, IsWhatArcCosinesAndSinesSay) {
  const Quaternion from = about({1, 2, 3}, 0.7);
  for (const double angle : {0.0, 1e-9, 1e-3, 0.5, 2.0, 3.0, 3.14}) {
    const Quaternion to = from * about({-2, 1, 1}, angle);
    for (const double share : {0.0, 0.1, 1.0 / 3, 0.5, 0.77, 1.0})
      EXPECT_LT(distance(turn_between(from, to, share), from.slerp(share, to)), 1e-13)
          << angle << " " << share;
  }
}

TEST(TurnBetween, BeginsAndEndsWhereItIsTold) {
  const Quaternion from = about({1, 2, 3}, 0.7), to = about({0, 1, 1}, 2);
  EXPECT_LT(distance(turn_between(from, to, 0), from), 1e-15);
  EXPECT_LT(distance(turn_between(from, to, 1), to), 1e-15);
}

TEST(TurnBetween, GoesTheShorterWayHoweverTurnsAreWritten) {
  Quaternion end = about(Vec3::UnitZ(), std::numbers::pi / 2);
  end.coeffs() *= -1;
  const Quaternion middle = turn_between(Quaternion::Identity(), end, 0.5);
  EXPECT_LT(distance(middle, about(Vec3::UnitZ(), std::numbers::pi / 4)), 1e-15);
}

// No function of libm: these bits hold on every machine.
TEST(TurnBetween, HasTheBitsOnRecord) {
  const Quaternion turn = turn_between({0.8, 0.6, 0, 0}, {0.28, 0, 0.96, 0}, 0.3);
  const Vec4 on_record(0x1.fda04fc568e7ap-2, 0x1.8c02c2895b374p-2, 0, 0x1.8d809c37a33d3p-1);
  EXPECT_EQ(turn.coeffs(), on_record) << std::hexfloat << turn.coeffs().transpose();
}

}  // namespace
}  // namespace drape
