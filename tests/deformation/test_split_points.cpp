#include <gtest/gtest.h>

#include "deformation/split_points.h"
#include "sheets.h"

namespace drape {
namespace {

// 24 bits in each part, of which the sign of the low one is one more.
TEST(SplitPoints, BothPartsTogetherAreThePointToFortyNineBits) {
  test::Random random(3);
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i)
    points.push_back(Vec3(random.between(-1, 1), random.between(-10, 10), random.between(-1000, 1000)));
  SplitPoints split;
  split_points(points, points.size(), split);
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Vec3 high(split.high[v].x, split.high[v].y, split.high[v].z);
    const Vec3 low(split.low[v].x, split.low[v].y, split.low[v].z);
    for (int k = 0; k < 3; ++k)
      EXPECT_LE(std::abs(high[k] + low[k] - points[v][k]), std::ldexp(std::abs(points[v][k]), -49)) << v;
  }
}

}  // namespace
}  // namespace drape
