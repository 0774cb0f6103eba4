#include <gtest/gtest.h>

#include <numeric>

#include "deformation/momentum.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;

struct Step {
  FreePiece piece;
  std::vector<double> masses;
  std::vector<Vec3> start, before, after;
};

// A step of 40 points of which the piece has the first 30; the pull has cost momentum.
Step random_step(unsigned seed) {
  Random random(seed);
  Step step;
  step.piece.vertices.resize(30);
  std::iota(step.piece.vertices.begin(), step.piece.vertices.end(), 0);
  step.masses = test::random_masses(40, random);
  for (int i = 0; i < 40; ++i) step.start.push_back(Vec3(2, -1, 3) + random.vector());
  step.before = test::shaken(step.start, 0.1, random);
  step.after = test::shaken(step.before, 0.05, random);
  return step;
}

Vec3 linear(const Step& step, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (const int v : step.piece.vertices) sum += step.masses[v] * x[v];
  return sum;
}

Vec3 centre(const Step& step) {
  double total = 0;
  for (const int v : step.piece.vertices) total += step.masses[v];
  return linear(step, step.start) / total;
}

// Of a step from `start` to x, about the centre of mass at the start, times the step's length.
Vec3 angular(const Step& step, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (const int v : step.piece.vertices)
    sum += step.masses[v] * (step.start[v] - centre(step)).cross(x[v] - step.start[v]);
  return sum;
}

std::vector<Vec3> restored(const Step& step) {
  std::vector<Vec3> x = step.after;
  restore_angular_momentum(step.piece, step.masses, step.start, step.before, x);
  return x;
}

TEST(Momentum, AngularMomentumIsRestored) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    const Step step = random_step(seed);
    const Vec3 wanted = angular(step, step.before);
    ASSERT_GT((angular(step, step.after) - wanted).norm(), 1e-3);
    EXPECT_LT((angular(step, restored(step)) - wanted).norm(), 1e-11 * wanted.norm());
  }
}

TEST(Momentum, LinearMomentumStays) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    const Step step = random_step(seed);
    EXPECT_LT((linear(step, restored(step)) - linear(step, step.after)).norm(), 1e-13 * 100);
  }
}

TEST(Momentum, PointsOfOtherPiecesStay) {
  const Step step = random_step(3);
  const std::vector<Vec3> x = restored(step);
  for (int v = 30; v < 40; ++v) EXPECT_EQ(x[v], step.after[v]);
  EXPECT_NE(x[0], step.after[0]);
}

TEST(Momentum, ThePieceTurnsAsARigidBody) {
  const Step step = random_step(4);
  const std::vector<Vec3> x = restored(step);
  for (const int a : step.piece.vertices)
    for (const int b : step.piece.vertices)
      EXPECT_NEAR((x[a] - step.after[a] - x[b] + step.after[b]).dot(step.start[a] - step.start[b]), 0, 1e-14);
}

TEST(Momentum, APullThatLosesNothingIsLeftAlone) {
  Step step = random_step(5);
  step.after = step.before;
  for (const int v : step.piece.vertices) step.after[v] += Vec3(0.1, 0.2, 0.3);
  EXPECT_LT(test::farthest(restored(step), step.after), 1e-14);
}

TEST(Momentum, ALineOfPointsStaysFiniteAndGetsItsTurningBack) {
  Step step = random_step(6);
  for (Vec3& x : step.start) x = Vec3(x.x(), 0, 0);
  const std::vector<Vec3> x = restored(step);
  for (const Vec3& point : x) ASSERT_TRUE(point.allFinite());
  const Vec3 error = angular(step, x) - angular(step, step.before);
  EXPECT_LT(error.norm(), 1e-10);
}

}  // namespace
}  // namespace drape
