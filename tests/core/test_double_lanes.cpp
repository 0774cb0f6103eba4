#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/double_lanes.h"

namespace drape {
namespace {

constexpr FourIndices scattered = {4, 0, 3, 1};

std::vector<Vec3> some_points() {
  std::vector<Vec3> points;
  for (int i = 0; i < 5; ++i) points.push_back(Vec3(i + 0.1, 10 * i + 0.2, 100 * i + 0.3));
  return points;
}

std::array<double, 4> values(DoubleLanes lanes) {
  std::array<double, 4> result{};
  _mm256_storeu_pd(result.data(), lanes.v);
  return result;
}

TEST(DoubleLanes, LanesOfPointsAreThePoints) {
  const std::vector<Vec3> points = some_points();
  const LaneVec3<DoubleLanes> lanes = load_lanes(points.data(), scattered);
  const std::array<Vec3, 4> each = each_lane(lanes);
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const Vec3& point = points[scattered[lane]];
    EXPECT_EQ(each[lane], point);
    EXPECT_EQ(values(lanes.x)[lane], point.x());
    EXPECT_EQ(values(lanes.y)[lane], point.y());
    EXPECT_EQ(values(lanes.z)[lane], point.z());
  }
}

TEST(DoubleLanes, OperationsAreThoseOfEachLane) {
  const std::vector<double> numbers = {0.1, -2, 3e9, 7, 1.0 / 3};
  const DoubleLanes a = load_lanes(numbers.data(), scattered), b = load_lanes(numbers.data(), {1, 2, 0, 4});
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const double x = numbers[scattered[lane]], y = values(b)[lane];
    EXPECT_EQ(values(a + b)[lane], x + y);
    EXPECT_EQ(values(a - b)[lane], x - y);
    EXPECT_EQ(values(a * b)[lane], x * y);
    EXPECT_EQ(values(a / b)[lane], x / y);
    EXPECT_EQ(values(square_root(a * a))[lane], std::sqrt(x * x));
    EXPECT_EQ(values(multiply_add(a, b, a))[lane], std::fma(x, y, x));
    EXPECT_EQ(values(subtract_product(a, b, a))[lane], std::fma(-x, y, x));
    EXPECT_EQ(values(where_positive(b, a, 5))[lane], y > 0 ? x : 5);
  }
}

TEST(DoubleLanes, TheSumIsOfAllLanes) {
  const std::vector<Vec3> points = some_points();
  const Vec3 sum = sum_of_lanes(load_lanes(points.data(), scattered));
  EXPECT_EQ(sum, (points[4] + points[0]) + (points[3] + points[1]));
}

}  // namespace
}  // namespace drape
