#include <gtest/gtest.h>

#include "core/parallel.h"
#include "deformation/seams.h"
#include "deformation/sheets.h"

namespace drape {
namespace {

using namespace test;

std::vector<Vec3> scattered(int count, Random& random) {
  std::vector<Vec3> x;
  for (int i = 0; i < count; ++i) x.push_back(random.vector());
  return x;
}

// Chains, so that seams share vertices.
std::vector<Seam> chain(int count) {
  std::vector<Seam> seams;
  for (int i = 0; i + 1 < count; ++i) seams.push_back({{i, i + 1}, 0.01, 0, 1});
  return seams;
}

std::vector<double> lengths_of(const SeamStage& stage, const std::vector<Vec3>& x) {
  std::vector<double> lengths;
  start_seams(stage, 0, x, lengths);
  return lengths;
}

TEST(Seams, ShrinkLinearlyFromTheirLengthToTheirGap) {
  const Seam seam{{0, 1}, 0.1, 2, 4};
  EXPECT_DOUBLE_EQ(thread_length(seam, 0.5, 2), 0.5);
  EXPECT_DOUBLE_EQ(thread_length(seam, 0.5, 3), 0.3);
  EXPECT_DOUBLE_EQ(thread_length(seam, 0.5, 4), 0.1);
  EXPECT_DOUBLE_EQ(thread_length(seam, 0.5, 9), 0.1);
}

TEST(Seams, PullTheirVerticesAsNearAsTheThreadIsLong) {
  const SeamStage stage = build_seams(2, {{{0, 1}, 0.1, 0, 1}});
  std::vector<Vec3> x = {{0, 0, 0}, {1, 0, 0}};
  const std::vector<double> lengths = lengths_of(stage, x);
  pull_seams(stage, lengths, {1.0, 3.0}, 0.5, x);  // it is 0.55 long by now
  EXPECT_LT((x[0] - Vec3(0.45 / 4, 0, 0)).norm(), 1e-15);
  EXPECT_LT((x[1] - Vec3(1 - 0.45 * 3 / 4, 0, 0)).norm(), 1e-15);
}

TEST(Seams, NeitherPushNorPullBeforeTheirTime) {
  const SeamStage stage = build_seams(4, {{{0, 1}, 0.1, 0, 1}, {{2, 3}, 0.1, 5, 6}});
  const std::vector<Vec3> before = {{0, 0, 0}, {0.05, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  std::vector<Vec3> x = before;
  pull_seams(stage, {1.0, 0.0}, {1, 1, 1, 1}, 4, x);
  EXPECT_EQ(x, before);
}

TEST(Seams, LeaveHeldVerticesWhereTheyAre) {
  const SeamStage stage = build_seams(2, {{{0, 1}, 0.1, 0, 1}});
  std::vector<Vec3> x = {{0, 0, 0}, {1, 0, 0}};
  pull_seams(stage, {1.0}, {0.0, 1.0}, 1, x);
  EXPECT_EQ(x[0], Vec3(0, 0, 0));
  EXPECT_LT((x[1] - Vec3(0.1, 0, 0)).norm(), 1e-15);
}

TEST(Seams, KeepBothMomenta) {
  Random random(3);
  const std::vector<double> masses = random_masses(40, random);
  const std::vector<Vec3> before = scattered(40, random);
  const SeamStage stage = build_seams(40, chain(40));
  // One colour at a time: each keeps angular momentum about the positions that it sees.
  std::vector<Vec3> x = before;
  pull_seams(stage, lengths_of(stage, before), inverses(masses), 0.5, x);
  EXPECT_LT(relative_momentum(masses, before, x), 1e-12);
  std::vector<Vec3> one = before;
  const SeamStage alone = build_seams(40, {{{3, 17}, 0.01, 0, 1}});
  pull_seams(alone, lengths_of(alone, before), inverses(masses), 0.5, one);
  EXPECT_LT(relative_angular_momentum(masses, before, one), 1e-12);
}

TEST(Seams, GiveTheSameBitsForAnyNumberOfThreads) {
  Random random(4);
  const std::vector<Vec3> before = scattered(3000, random);
  const SeamStage stage = build_seams(3000, chain(3000));
  const std::vector<double> lengths = lengths_of(stage, before), inverse(3000, 1.0);
  const auto pulled = [&](int threads) {
    const ThreadLimit limit(threads);
    std::vector<Vec3> x = before;
    pull_seams(stage, lengths, inverse, 0.7, x);
    return x;
  };
  EXPECT_EQ(pulled(1), pulled(4));
}

TEST(Seams, RecordTheirLengthOnlyWhenTheyStart) {
  const SeamStage stage = build_seams(2, {{{0, 1}, 0.1, 2, 3}});
  std::vector<double> lengths;
  start_seams(stage, 1, {{0, 0, 0}, {1, 0, 0}}, lengths);
  EXPECT_EQ(lengths, std::vector{0.0});
  start_seams(stage, 2, {{0, 0, 0}, {4, 0, 0}}, lengths);
  EXPECT_EQ(lengths, std::vector{4.0});
  start_seams(stage, 3, {{0, 0, 0}, {5, 0, 0}}, lengths);
  EXPECT_EQ(lengths, std::vector{4.0});
}

}  // namespace
}  // namespace drape
