#include <gtest/gtest.h>

#include <numeric>

#include "deformation/fibres.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;

// One fibre of `edges` edges, each `length` long.
FibreStage chain(int edges, double length, double compliance) {
  FibreStage stage;
  stage.vertices.resize(static_cast<std::size_t>(edges) + 1);
  std::iota(stage.vertices.begin(), stage.vertices.end(), 0);
  stage.vertex_begin = {0, stage.vertices.size()};
  stage.rest_lengths.assign(static_cast<std::size_t>(edges), length);
  stage.compliances.assign(static_cast<std::size_t>(edges), compliance);
  stage.color_begin = {0, 1};
  return stage;
}

std::vector<Vec3> straight_chain(int edges, double length) {
  std::vector<Vec3> x;
  for (int i = 0; i <= edges; ++i) x.emplace_back(0, -length * i, 0);
  return x;
}

// A chain in the shape of a wave, stretched by one hundredth.
std::vector<Vec3> stretched_wave(int edges, double length) {
  std::vector<Vec3> x = {Vec3::Zero()};
  for (int i = 0; i < edges; ++i) {
    const double angle = 0.5 * std::sin(0.7 * i);
    x.push_back(x.back() + 1.01 * length * Vec3(std::sin(angle), -std::cos(angle), 0));
  }
  return x;
}

double largest_strain(const FibreStage& stage, const std::vector<Vec3>& x) {
  double largest = 0;
  for (std::size_t i = 0; i < stage.rest_lengths.size(); ++i)
    largest = std::max(largest, std::abs((x[i + 1] - x[i]).norm() / stage.rest_lengths[i] - 1));
  return largest;
}

void pull(const FibreStage& stage, const std::vector<double>& inverse_masses, std::vector<Vec3>& x) {
  FibreScratch scratch;
  pull_fibres(stage, inverse_masses, scratch, x);
}

TEST(Fibres, AStiffChainIsBackToItsLengthsAfterAFewPulls) {
  const FibreStage stage = chain(30, 0.02, 0);
  std::vector<Vec3> x = stretched_wave(30, 0.02);
  ASSERT_NEAR(largest_strain(stage, x), 0.01, 1e-6);
  const std::vector<double> inverse_masses(31, 1000);
  for (int i = 0; i < 4; ++i) pull(stage, inverse_masses, x);
  EXPECT_LT(largest_strain(stage, x), 1e-10);
}

TEST(Fibres, AStraightChainIsBackAfterOnePull) {
  const FibreStage stage = chain(100, 0.01, 0);
  std::vector<Vec3> x = straight_chain(100, 0.013);
  pull(stage, std::vector<double>(101, 5), x);
  EXPECT_LT(largest_strain(stage, x), 1e-12);
}

TEST(Fibres, ACompressedChainIsRestoredToo) {
  const FibreStage stage = chain(20, 0.01, 0);
  std::vector<Vec3> x = straight_chain(20, 0.007);
  pull(stage, std::vector<double>(21, 5), x);
  EXPECT_LT(largest_strain(stage, x), 1e-12);
}

TEST(Fibres, BothMomentaAreKept) {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const FibreStage stage = chain(12, 0.1, random.between(0, 0.1));
    const std::vector<double> masses = test::random_masses(13, random);
    const std::vector<Vec3> before = test::shaken(straight_chain(12, 0.1), 0.05, random);
    std::vector<Vec3> after = before;
    pull(stage, test::inverses(masses), after);
    ASSERT_GT(test::farthest(before, after), 1e-3);
    EXPECT_LT(test::relative_momentum(masses, before, after), 1e-14);
    EXPECT_LT(test::relative_angular_momentum(masses, before, after), 1e-14);
  }
}

TEST(Fibres, PinnedPointsStayAndLengthsAreRestoredBetweenThem) {
  const FibreStage stage = chain(30, 0.02, 0);
  std::vector<Vec3> x = stretched_wave(30, 0.02);
  const Vec3 first = x[0], middle = x[17];
  std::vector<double> inverse_masses(31, 1000);
  inverse_masses[0] = inverse_masses[17] = 0;
  for (int i = 0; i < 30; ++i) pull(stage, inverse_masses, x);
  EXPECT_EQ(x[0], first);
  EXPECT_EQ(x[17], middle);
  EXPECT_LT(largest_strain(stage, x), 1e-10);
}

TEST(Fibres, EdgesBetweenPinnedPointsAreLeftAndStayFinite) {
  const FibreStage stage = chain(3, 0.1, 1e-6);
  const std::vector<Vec3> before = straight_chain(3, 0.2);
  std::vector<Vec3> x = before;
  pull(stage, std::vector<double>(4, 0), x);
  EXPECT_EQ(x, before);
}

TEST(Fibres, PointsThatCoincideGiveFiniteResults) {
  const FibreStage stage = chain(3, 0.1, 1e-6);
  std::vector<Vec3> x(4, Vec3(1, 1, 1));
  pull(stage, std::vector<double>(4, 1), x);
  for (const Vec3& point : x) EXPECT_TRUE(point.allFinite());
}

// One edge, equal masses m: a spring's implicit step leaves 1 / (1 + 2 k h2 / m) of the excess.
TEST(Fibres, ACompliantEdgeGivesUpItsImplicitShare) {
  const double stiffness = 300, step = 0.01, mass = 0.02;
  const FibreStage stage = chain(1, 1, 1 / (stiffness * step * step));
  std::vector<Vec3> x = straight_chain(1, 1.2);
  pull(stage, {1 / mass, 1 / mass}, x);
  EXPECT_NEAR((x[1] - x[0]).norm() - 1, 0.2 / (1 + 2 * stiffness * step * step / mass), 1e-13);
}

// Edge i carries the weight of all points below it, and stretches by that over its stiffness.
TEST(Fibres, AHangingChainStretchesByItsWeight) {
  const int edges = 10;
  const double stiffness = 500, mass = 0.05, gravity = 9.81, step = 0.1;
  const FibreStage stage = chain(edges, 0.1, 1 / (stiffness * step * step));
  std::vector<double> inverse_masses(edges + 1, 1 / mass);
  inverse_masses[0] = 0;
  std::vector<Vec3> x = straight_chain(edges, 0.1);
  for (int i = 0; i < 300; ++i) {  // each step from rest
    for (int v = 1; v <= edges; ++v) x[v].y() -= gravity * step * step;
    pull(stage, inverse_masses, x);
  }
  for (int i = 0; i < edges; ++i)
    EXPECT_NEAR((x[i + 1] - x[i]).norm() - 0.1, (edges - i) * mass * gravity / stiffness, 1e-9);
}

TEST(Fibres, AWholeSheetKeepsItsLinearMomentumAndNearsItsLengths) {
  Random random(2);
  const Sheet sheet = test::sheet_of(make_grid({1, 1}, {11, 11}), {.stretch_stiffness = 1e9});
  const FibreStage stage = build_fibres(sheet, 0.01);
  const std::vector<double> masses = test::random_masses(121, random);
  std::vector<Vec3> before = sheet.rest_positions;
  for (Vec3& x : before) x *= 1.05;
  std::vector<Vec3> after = before;
  for (int sweep = 0; sweep < 20; ++sweep) pull(stage, test::inverses(masses), after);
  EXPECT_LT(test::relative_momentum(masses, before, after), 1e-13);
  for (const Edge& edge : sheet.topology.edges) {
    const auto length = [&](const std::vector<Vec3>& x) {
      return (x[edge.vertices[1]] - x[edge.vertices[0]]).norm();
    };
    EXPECT_NEAR(length(after) / length(sheet.rest_positions), 1, 0.01);
  }
}

}  // namespace
}  // namespace drape
