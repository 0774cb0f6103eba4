#include <gtest/gtest.h>

#include "contact/closest_points.h"
#include "scene.h"

namespace drape {
namespace {

using test::Random;

Vec3 weighted(const ClosestPoints& closest, const FourPoints& x, int begin, int end) {
  Vec3 sum = Vec3::Zero();
  for (int i = begin; i < end; ++i) sum += closest.weights[i] * x[i];
  return sum;
}

// Weights of each side are barycentric: within [0, 1], their sum 1 (the second side's negative).
void expect_barycentric(PairKind kind, const ClosestPoints& closest) {
  double sums[2] = {0, 0};
  for (int i = 0; i < 4; ++i) {
    const int side = i < first_side(kind) ? 0 : 1;
    const double weight = side == 0 ? closest.weights[i] : -closest.weights[i];
    EXPECT_GE(weight, -1e-14);
    EXPECT_LE(weight, 1 + 1e-14);
    sums[side] += weight;
  }
  EXPECT_NEAR(sums[0], 1, 1e-13);
  EXPECT_NEAR(sums[1], 1, 1e-13);
}

// Both sides are convex: the points are the closest if and only if no corner of a side lies farther towards
// the other side than its closest point. Returns by how many metres one does.
double error_of(PairKind kind, const ClosestPoints& closest, const FourPoints& x) {
  const int n = first_side(kind);
  if (closest.distance < 1e-12) return 0;
  const Vec3 direction = closest.difference / closest.distance;
  const Vec3 first = weighted(closest, x, 0, n), second = -weighted(closest, x, n, 4);
  double error = 0;
  for (int i = 0; i < n; ++i) error = std::max(error, direction.dot(first - x[i]));
  for (int i = n; i < 4; ++i) error = std::max(error, direction.dot(x[i] - second));
  return error;
}

void expect_closest(PairKind kind, const FourPoints& x, double tolerance = 1e-12) {
  const ClosestPoints closest = closest_points(kind, x);
  expect_barycentric(kind, closest);
  EXPECT_LT((closest.difference - weighted(closest, x, 0, 4)).norm(), 1e-13);
  EXPECT_EQ(closest.distance, closest.difference.norm());
  EXPECT_LT(error_of(kind, closest, x), tolerance);
}

// The least distance over a fine lattice of points on both sides.
double sampled_distance(PairKind kind, const FourPoints& x) {
  constexpr int n = 40;
  double least = 1e300;
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= n; ++k) {
      const double s = i / double(n), t = k / double(n);
      if (kind == PairKind::edge_edge)
        least = std::min(least, (x[0] + s * (x[1] - x[0]) - x[2] - t * (x[3] - x[2])).norm());
      else if (s + t <= 1)
        least = std::min(least, (x[0] - x[1] - s * (x[2] - x[1]) - t * (x[3] - x[1])).norm());
    }
  return least;
}

constexpr PairKind both_kinds[] = {PairKind::point_triangle, PairKind::edge_edge};

TEST(ClosestPoints, AreTheClosestOnRandomPairs) {
  Random random(1);
  for (int trial = 0; trial < 20000 && !testing::Test::HasFailure(); ++trial)
    for (const PairKind kind : both_kinds) expect_closest(kind, random.four_points());
}

TEST(ClosestPoints, AgreeWithSampling) {
  Random random(2);
  for (int trial = 0; trial < 300; ++trial)
    for (const PairKind kind : both_kinds) {
      const FourPoints x = random.four_points();
      const double distance = closest_points(kind, x).distance, sampled = sampled_distance(kind, x);
      ASSERT_LE(distance, sampled + 1e-14);
      ASSERT_GE(distance, sampled - 0.15);  // the lattice is that coarse
    }
}

TEST(ClosestPoints, ParallelEdgesOfAllOverlaps) {
  Random random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    const Vec3 direction = random.vector(), a = random.vector(), b = random.vector();
    const auto place = [&] { return random.between(-2, 2) * direction; };
    expect_closest(PairKind::edge_edge, {a + place(), a + place(), b + place(), b + place()}, 1e-7);
  }
}

TEST(ClosestPoints, NearlyParallelEdges) {
  Random random(4);
  for (double angle = 1e-1; angle > 1e-12; angle *= 0.5) {
    const Vec3 direction = random.vector(), a = random.vector(), b = random.vector();
    const FourPoints x = {a, a + direction, b, b + direction + random.vector(angle)};
    expect_closest(PairKind::edge_edge, x, 1e-6);
  }
}

TEST(ClosestPoints, EdgesWithoutLength) {
  Random random(5);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3 a = random.vector(), b = random.vector(), c = random.vector();
    expect_closest(PairKind::edge_edge, {a, a, b, c});
    expect_closest(PairKind::edge_edge, {b, c, a, a});
    expect_closest(PairKind::edge_edge, {a, a, b, b});
  }
}

TEST(ClosestPoints, TrianglesWhoseThirdCornerIsAnother) {
  Random random(6);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3 p = random.vector(), a = random.vector(), b = random.vector();
    for (const FourPoints& x : {FourPoints{p, a, b, a}, {p, b, a, a}, {p, a, a, a}})
      expect_closest(PairKind::point_triangle, x);
  }
}

TEST(ClosestPoints, ThinTriangles) {
  Random random(8);
  for (double height = 1e-3; height > 1e-11 && !testing::Test::HasFailure(); height *= 0.5)
    for (int trial = 0; trial < 100; ++trial) {
      const Vec3 a = random.vector(), b = random.vector();
      const Vec3 c = a + random.between(-0.5, 1.5) * (b - a) + random.vector(height);
      expect_closest(PairKind::point_triangle, {random.vector(), a, b, c}, 1e-7);
    }
}

TEST(ClosestPoints, CrossingSidesHaveNoDistance) {
  const FourPoints inside = {Vec3(0.2, 0.3, 0), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_NEAR(closest_point_triangle(inside).distance, 0, 1e-16);
  const FourPoints cross = {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 1, 0)};
  EXPECT_NEAR(closest_edge_edge(cross).distance, 0, 1e-16);
}

TEST(ClosestPoints, DifferenceLeadsFromTheSecondSideToTheFirst) {
  const ClosestPoints above =
      closest_point_triangle({Vec3(0.2, 0.2, 3), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
  EXPECT_LT((above.difference - Vec3(0, 0, 3)).norm(), 1e-15);
}

TEST(ClosestPoints, EdgesTellWhetherBothPointsLieBetweenTheirEnds) {
  const Vec3 a(-1, 0, 0), b(1, 0, 0);
  EXPECT_TRUE(closest_edge_edge({a, b, Vec3(0, -1, 1), Vec3(0, 1, 1)}).inside_edges);
  EXPECT_FALSE(closest_edge_edge({a, b, Vec3(0, 1, 1), Vec3(0, 2, 1)}).inside_edges);
  EXPECT_FALSE(closest_edge_edge({a, b, Vec3(2, -1, 1), Vec3(2, 1, 1)}).inside_edges);
}

}  // namespace
}  // namespace drape
