#include <gtest/gtest.h>

#include <numeric>

#include "deformation/momentum.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;

constexpr double duration = 0.01;

struct Step {
  FreePiece piece;
  std::vector<double> masses;
  std::vector<Vec3> x0, v0, a, x1, v1;
};

// A step of ten points more than the piece has, which are its first, and which has lost momentum.
Step random_step(unsigned seed, int points_of_piece = 30) {
  Random random(seed);
  Step step;
  const auto points = static_cast<std::size_t>(points_of_piece) + 10;
  step.piece.vertices.resize(points - 10);
  std::iota(step.piece.vertices.begin(), step.piece.vertices.end(), 0);
  step.masses = test::random_masses(points, random);
  for (std::size_t i = 0; i < points; ++i) step.x0.push_back(Vec3(2, -1, 3) + random.vector());
  step.v0 = test::shaken(test::zeros(points), 2, random);
  step.a = test::shaken(std::vector<Vec3>(points, Vec3(0, -9.81, 0)), 5, random);
  step.x1 = test::shaken(step.x0, 0.1, random);
  step.v1 = test::shaken(step.v0, 1, random);
  return step;
}

Vec3 linear(const Step& step, const std::vector<Vec3>& v) {
  Vec3 sum = Vec3::Zero();
  for (const int i : step.piece.vertices) sum += step.masses[i] * v[i];
  return sum;
}

double mass(const Step& step) {
  double sum = 0;
  for (const int i : step.piece.vertices) sum += step.masses[i];
  return sum;
}

// About the centre of mass.
Vec3 angular(const Step& step, const std::vector<Vec3>& x, const std::vector<Vec3>& v) {
  const Vec3 centre = linear(step, x) / mass(step);
  Vec3 sum = Vec3::Zero();
  for (const int i : step.piece.vertices) sum += step.masses[i] * (x[i] - centre).cross(v[i]);
  return sum;
}

Vec3 wanted_linear(const Step& step) { return linear(step, step.v0) + duration * linear(step, step.a); }
Vec3 wanted_angular(const Step& step) {
  return angular(step, step.x0, step.v0) + duration * angular(step, step.x0, step.a);
}

struct Restored {
  std::vector<Vec3> x, v;
};

Restored restored(const Step& step) {
  Restored result{step.x1, step.v1};
  restore_momenta(step.piece, step.masses, step.x0, step.v0, step.a, duration, result.x, result.v);
  return result;
}

TEST(Momentum, BothMomentaAreRestoredWithWhatAccelerationsAdd) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    const Step step = random_step(seed);
    const std::vector<Vec3> v = restored(step).v;
    ASSERT_GT((linear(step, step.v1) - wanted_linear(step)).norm(), 1e-2);
    ASSERT_GT((angular(step, step.x1, step.v1) - wanted_angular(step)).norm(), 1e-2);
    EXPECT_LT((linear(step, v) - wanted_linear(step)).norm(), 1e-12);
    EXPECT_LT((angular(step, step.x1, v) - wanted_angular(step)).norm(), 1e-10);
  }
}

// Sums are taken four points and 512 at a time.
TEST(Momentum, PiecesOfAnySizeGetTheirMomentaBack) {
  for (const int points : {3, 4, 511, 512, 513, 1027}) {
    const Step step = random_step(9, points);
    const std::vector<Vec3> v = restored(step).v;
    EXPECT_LT((linear(step, v) - wanted_linear(step)).norm(), 1e-13 * points) << points;
    EXPECT_LT((angular(step, step.x1, v) - wanted_angular(step)).norm(), 1e-11 * points) << points;
  }
}

TEST(Momentum, TheCentreOfMassGoesTheWayOfItsMomentum) {
  const Step step = random_step(8);
  const double mass = std::accumulate(step.masses.begin(), step.masses.begin() + 30, 0.0);
  const Vec3 way = linear(step, restored(step).x) / mass - linear(step, step.x0) / mass;
  EXPECT_LT((way - duration * wanted_linear(step) / mass).norm(), 1e-14);
}

TEST(Momentum, PointsOfOtherPiecesStay) {
  const Step step = random_step(3);
  const std::vector<Vec3> v = restored(step).v;
  for (int i = 30; i < 40; ++i) EXPECT_EQ(v[i], step.v1[i]);
  EXPECT_NE(v[0], step.v1[0]);
}

TEST(Momentum, WhatIsAddedIsARigidMotion) {
  const Step step = random_step(4);
  const std::vector<Vec3> v = restored(step).v;
  for (const int a : step.piece.vertices)
    for (const int b : step.piece.vertices)
      EXPECT_NEAR((v[a] - step.v1[a] - v[b] + step.v1[b]).dot(step.x1[a] - step.x1[b]), 0, 1e-13);
}

TEST(Momentum, AStepOfFreeFallIsLeftAlone) {
  Step step = random_step(5);
  step.x1 = step.x0;
  for (std::size_t i = 0; i < 40; ++i) step.v1[i] = step.v0[i] + duration * step.a[i];
  for (std::size_t i = 0; i < 40; ++i) step.x1[i] += duration * step.v1[i];
  EXPECT_LT(test::farthest(restored(step).x, step.x1), 1e-14);
}

TEST(Momentum, RestoringTwiceIsRestoringOnce) {
  Step step = random_step(6);
  const auto [x, v] = restored(step);
  step.x1 = x;
  step.v1 = v;
  EXPECT_LT(test::farthest(restored(step).v, v), 1e-12);
  EXPECT_LT(test::farthest(restored(step).x, x), 1e-12);
}

TEST(Momentum, ALineOfPointsStaysFiniteAndGetsItsTurningBack) {
  Step step = random_step(7);
  for (Vec3& x : step.x0) x = Vec3(x.x(), 0, 0);
  step.x1 = step.x0;
  const std::vector<Vec3> v = restored(step).v;
  ASSERT_TRUE(test::all_finite(v));
  EXPECT_LT((angular(step, step.x1, v) - wanted_angular(step)).norm(), 1e-10);
}

}  // namespace
}  // namespace drape
