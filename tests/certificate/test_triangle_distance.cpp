#include "certificate/triangle_distance.h"

#include <gtest/gtest.h>

#include "contact/scene.h"

namespace drape {
namespace {

using test::Random;

const TrianglePoints floor{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

// By the other code that knows of such distances: contact's.
double by_contact(const TrianglePoints& a, const TrianglePoints& b) {
  double least = 1e300;
  for (int i = 0; i < 3; ++i) {
    least = std::min({least, closest_point_triangle({a[i], b[0], b[1], b[2]}).distance,
                      closest_point_triangle({b[i], a[0], a[1], a[2]}).distance});
    for (int k = 0; k < 3; ++k)
      least = std::min(least, closest_edge_edge({a[i], a[(i + 1) % 3], b[k], b[(k + 1) % 3]}).distance);
  }
  return least;
}

TEST(TriangleDistance, EqualsContactsOwn) {
  Random random(1);
  for (int trial = 0; trial < 5000; ++trial) {
    const double size = trial % 2 ? 1 : 0.1;
    TrianglePoints a, b;
    for (int k = 0; k < 3; ++k) a[k] = random.vector(size), b[k] = random.vector(size) + Vec3(0.3, 0.2, 0.1);
    if (triangles_meet(a, b)) continue;
    ASSERT_NEAR(triangle_distance(a, b), by_contact(a, b), 1e-12) << "trial " << trial;
  }
}

TEST(TriangleDistance, IsKnownAboveBesideAndAcross) {
  EXPECT_DOUBLE_EQ(triangle_distance(floor, {Vec3(1, 1, 0.5), Vec3(1, 2, 3), Vec3(2, 1, 3)}), 0.5);
  EXPECT_DOUBLE_EQ(triangle_distance(floor, {Vec3(-3, 1, 4), Vec3(-4, 1, 4), Vec3(-3, 1, 9)}), 5);
  EXPECT_DOUBLE_EQ(triangle_distance(floor, {Vec3(1, -2, 0), Vec3(2, -2, 0), Vec3(1, -3, 0)}), 2);
  // Edges that cross each other.
  EXPECT_DOUBLE_EQ(triangle_distance(floor, {Vec3(2, -2, 0), Vec3(2, 0, -2), Vec3(2, -9, -9)}), std::sqrt(2));
}

TEST(TriangleDistance, OfNeedlesIsThatOfTheirEdges) {
  const TrianglePoints needle{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(2, 0, 1)};
  EXPECT_DOUBLE_EQ(triangle_distance(needle, {Vec3(1, 3, 1), Vec3(1, 3, 1), Vec3(1, 3, 1)}), 3);
}

TEST(TriangleDistance, OfASegmentIsZeroWhereItPierces) {
  EXPECT_EQ(segment_triangle_distance({1, 1, -1}, {1, 1, 1}, floor), 0);
  EXPECT_DOUBLE_EQ(segment_triangle_distance({1, 1, 0.25}, {1, 1, 1}, floor), 0.25);
  EXPECT_DOUBLE_EQ(segment_distance({0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {4, 0, 0}), 2);
}

}  // namespace
}  // namespace drape
