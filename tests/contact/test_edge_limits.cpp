#include "contact/edge_limits.h"

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "scene.h"

namespace drape {
namespace {

using test::Random;

// A chain of points 1 m apart, whose edges may be 0.9 to 1.1 m long; in two colours.
struct Chain {
  EdgeLimits limits;
  std::vector<double> inverse_masses;
  std::vector<Vec3> x;

  explicit Chain(int points) : inverse_masses(points, 1) {
    for (int i = 0; i < points; ++i) x.emplace_back(i, 0, 0);
    std::vector<EdgeLimits::Edge> edges;
    std::vector<std::size_t> color_begin;
    for (const int first : {0, 1}) {
      color_begin.push_back(edges.size());
      for (int i = first; i + 1 < points; i += 2) edges.push_back({{i, i + 1}, 0.9, 1.1});
    }
    color_begin.push_back(edges.size());
    limits = make_edge_limits(edges, color_begin, points);
  }

  void pull() {
    EdgesInDoubt in_doubt = find_edges_out_of_limits(limits, x);
    pull_within_limits(limits, inverse_masses, in_doubt, x);
  }
  double length(int edge) const { return (x[edge + 1] - x[edge]).norm(); }
};

TEST(EdgeLimits, EdgesWithinThemKeepTheirBits) {
  Chain chain(5);
  chain.x = {{0, 0, 0}, {1.09, 0, 0}, {1.09, 0.91, 0}, {1.09, 0.91, 1}, {2, 0.91, 1}};
  const std::vector<Vec3> before = chain.x;
  chain.pull();
  EXPECT_EQ(chain.x, before);
}

TEST(EdgeLimits, OneEdgeEndsAtItsLimitAndLighterPointsGoFarther) {
  for (const double length : {0.5, 2.0}) {
    Chain chain(2);
    chain.inverse_masses = {3, 1};
    chain.x[1].x() = length;
    chain.pull();
    EXPECT_NEAR(chain.length(0), length > 1 ? 1.1 : 0.9, 1e-14);
    EXPECT_NEAR(chain.x[0].x(), -3 * (chain.x[1].x() - length), 1e-14);
  }
}

// As a contact moves one point of a cloth.
TEST(EdgeLimits, WhatMovedOnePointIsHandedOnToThoseAround) {
  Chain chain(9);
  chain.x[4].x() += 0.6;
  const double worst = chain.length(3);
  chain.pull();
  for (int edge = 0; edge < 8; ++edge) {
    EXPECT_LT(chain.length(edge), 1 + 0.5 * (worst - 1));
    EXPECT_GT(chain.length(edge), 1 - 0.5 * (worst - 1));
  }
  EXPECT_GT(chain.x[2].x(), 2.01);
  EXPECT_GT(chain.x[6].x(), 6.01);
}

TEST(EdgeLimits, WhatIsHeldStays) {
  Chain chain(3);
  chain.inverse_masses = {0, 1, 0};
  chain.x[2].x() = 3;
  chain.pull();
  EXPECT_EQ(chain.x[0], Vec3(0, 0, 0));
  EXPECT_EQ(chain.x[2], Vec3(3, 0, 0));
}

TEST(EdgeLimits, LinearMomentumIsKept) {
  Random random(1);
  Chain chain(40);
  for (int v = 0; v < 40; ++v) {
    chain.inverse_masses[v] = random.between(0.2, 5);
    chain.x[v] += random.vector(0.5);
  }
  const std::vector<Vec3> before = chain.x;
  chain.pull();
  Vec3 sum = Vec3::Zero();
  double moved = 0;
  for (int v = 0; v < 40; ++v) {
    const Vec3 momentum = (chain.x[v] - before[v]) / chain.inverse_masses[v];
    sum += momentum;
    moved += momentum.norm();
  }
  EXPECT_GT(moved, 1);
  EXPECT_LT(sum.norm(), 1e-12);
}

TEST(EdgeLimits, AnEdgeIsPulledAlongItself) {
  Chain pair(2);
  pair.x = {{0, 1, 2}, {3, 1, -1}};
  const Vec3 along = (pair.x[1] - pair.x[0]).normalized(), start = pair.x[0];
  pair.pull();
  EXPECT_GT((pair.x[0] - start).norm(), 0.1);
  EXPECT_LT((pair.x[0] - start).cross(along).norm(), 1e-14);
}

// The slow way: every edge, in every sweep.
void pull_all(const EdgeLimits& limits, const std::vector<double>& inverse_masses, std::vector<Vec3>& x) {
  for (int sweep = 0; sweep < 5; ++sweep)
    for (const EdgeLimits::Edge& edge : limits.edges) {
      const EdgeLimits one = make_edge_limits({edge}, {0, 1}, static_cast<int>(x.size()));
      EdgesInDoubt in_doubt = find_edges_out_of_limits(one, x);
      pull_within_limits(one, inverse_masses, in_doubt, x);
    }
}

// Others move a point between two calls.
TEST(EdgeLimits, GoOnWhereTheLastCallEnded) {
  Random random(4);
  Chain chain(400);
  for (Vec3& p : chain.x) p += random.vector(0.2);
  Chain again = chain;
  EdgesInDoubt in_doubt = find_edges_out_of_limits(chain.limits, chain.x);
  for (int call = 0; call < 3; ++call) {
    for (const int v : {10, 11, 200}) {
      const Vec3 way = random.vector(0.5);
      chain.x[v] += way;
      again.x[v] += way;
      doubt_edges_at(chain.limits, v, in_doubt);
    }
    pull_within_limits(chain.limits, chain.inverse_masses, in_doubt, chain.x);
    again.pull();
    ASSERT_EQ(chain.x, again.x) << "call " << call;
  }
}

TEST(EdgeLimits, EdgesThatHaveNotMovedNeedNoLook) {
  Random random(3);
  Chain chain(2000);
  for (int v = 0; v < 2000; ++v) {
    chain.inverse_masses[v] = random.between(0, 5);
    if (v % 7 == 0) chain.x[v] += random.vector(0.7);
  }
  std::vector<Vec3> slow = chain.x;
  pull_all(chain.limits, chain.inverse_masses, slow);
  chain.pull();
  double apart = 0;
  for (int v = 0; v < 2000; ++v) apart = std::max(apart, (slow[v] - chain.x[v]).norm());
  EXPECT_LT(apart, 1e-12);  // an edge by itself is pulled again for what rounding has left
}

TEST(EdgeLimits, TheSameBitsWithAnyNumberOfThreads) {
  std::vector<std::vector<Vec3>> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    Random random(2);
    Chain chain(20000);
    for (Vec3& p : chain.x) p += random.vector(0.5);
    chain.pull();
    results.push_back(chain.x);
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

}  // namespace
}  // namespace drape
