#include "mesh/figure.h"

#include <gtest/gtest.h>

#include <numbers>

namespace drape {
namespace {

Mat4 moved(const Vec3& way) {
  Mat4 matrix = Mat4::Identity();
  matrix.topRightCorner<3, 1>() = way;
  return matrix;
}

NodeMotion resting() {
  return {{{0}, {Vec3::Zero()}}, {{0}, {Quaternion::Identity()}}, {{0}, {Vec3::Ones()}}};
}

Quaternion about_z(double angle) { return Quaternion(Eigen::AngleAxisd(angle, Vec3::UnitZ())); }

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LT((a - b).norm(), 1e-12) << a.transpose(); }

// One node that moves, and one point at x = 1 that hangs on it.
Figure of_motion(const NodeMotion& motion) {
  return {{{-1, 0, moved({9, 9, 9})}}, {motion}, {{0, {Vec3::UnitX()}, {}}}};
}

TEST(Figure, APlaceIsStraightBetweenKeysAndConstantOutside) {
  NodeMotion motion = resting();
  motion.place = {{1, 3}, {Vec3(0, 0, 0), Vec3(0, 4, 0)}};
  const Figure figure = of_motion(motion);
  for (const auto& [time, y] : {std::pair{0.0, 0.0}, {1, 0}, {1.5, 1}, {3, 4}, {100, 4}})
    expect_near(pose_figure(figure, time)[0], {1, y, 0});
}

TEST(Figure, ATurnGoesTheShorterWayAtAnEvenPace) {
  NodeMotion motion = resting();
  Quaternion end = about_z(std::numbers::pi / 2);
  end.coeffs() *= -1;  // the same turn, written the other way
  motion.turn = {{0, 1}, {Quaternion::Identity(), end}};
  for (const double time : {0.0, 0.25, 0.5, 1.0}) {
    const double angle = time * std::numbers::pi / 2;
    expect_near(pose_figure(of_motion(motion), time)[0], {std::cos(angle), std::sin(angle), 0});
  }
}

TEST(Figure, ScaleComesBeforeTurnAndPlace) {
  NodeMotion motion = resting();
  motion.scale.values = {Vec3(3, 1, 1)};
  motion.turn.values = {about_z(std::numbers::pi / 2)};
  motion.place.values = {Vec3(0, 0, 1)};
  expect_near(pose_figure(of_motion(motion), 0)[0], {0, 3, 1});
}

TEST(Figure, ChildrenGoWithTheirParents) {
  NodeMotion motion = resting();
  motion.turn.values = {about_z(std::numbers::pi / 2)};
  const Figure figure{{{-1, 0, Mat4::Identity()}, {0, -1, moved({2, 0, 0})}},
                      {motion},
                      {{1, {Vec3::Zero(), Vec3::UnitX()}, {}}, {0, {Vec3::UnitY()}, {}}}};
  const std::vector<Vec3> points = pose_figure(figure, 0);
  ASSERT_EQ(points.size(), 3u);  // surface after surface
  expect_near(points[0], {0, 2, 0});
  expect_near(points[1], {0, 3, 0});
  expect_near(points[2], {-1, 0, 0});
}

// Two bones at x = 0 and x = 1, as modelled; the second goes up by 2.
TEST(Figure, ASkinnedPointGoesWithItsBonesByTheirShares) {
  NodeMotion motion = resting();
  motion.place.values = {Vec3(1, 2, 0)};
  const Bone still{Mat4::Identity(), 0, {{0, 1.0}, {1, 0.5}, {2, 3.0}}};
  const Bone raised{moved({-1, 0, 0}), 1, {{1, 0.5}, {2, 1.0}}};
  const Figure figure{{{-1, -1, Mat4::Identity()}, {-1, 0, moved({1, 0, 0})}, {-1, -1, moved({0, 0, 7})}},
                      {motion},
                      {{2, std::vector<Vec3>(4, Vec3(0.5, 0, 0)), {still, raised}}}};
  const std::vector<Vec3> points = pose_figure(figure, 0);
  expect_near(points[0], {0.5, 0, 0});
  expect_near(points[1], {0.5, 1, 0});
  expect_near(points[2], {0.5, 0.5, 0});  // shares need not sum up to 1
  expect_near(points[3], {0.5, 0, 7});    // one without bones hangs on the surface's node
}

}  // namespace
}  // namespace drape
