#include <gtest/gtest.h>

#include <limits>

#include "deformation/fibres.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;

constexpr double unlimited = std::numeric_limits<double>::infinity();

struct Chain {
  FibreStage stage;
  int edges;
  double length;
};

// One fibre of `edges` edges in the first lane; fillers in the others.
Chain chain_of(int edges, double length, double compliance, double longest = unlimited) {
  FibreStage stage;
  const auto rows = static_cast<std::size_t>(edges) + 1;
  stage.vertices.resize(rows);
  stage.rest_lengths.resize(rows, LaneRow{});
  stage.compliances.resize(rows, LaneRow{});
  stage.longest.resize(rows, LaneRow{});
  for (int i = 0; i <= edges; ++i) {
    stage.vertices[i].set(0, i);
    for (int lane = 1; lane < Lanes::count; ++lane) stage.vertices[i].set(lane, edges + 1);
    stage.rest_lengths[i].values[0] = static_cast<float>(length);
    stage.compliances[i].values[0] = static_cast<float>(compliance);
    stage.longest[i].values[0] = static_cast<float>(longest);
  }
  stage.row_begin = {0, rows};
  stage.longest_group = rows;
  stage.color_begin = {0, 1};
  return {stage, edges, length};
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

// From points at `x` moved by `ways`: what the pull makes of the ways.
std::vector<Vec3> pulled_ways(const FibreStage& stage, const std::vector<double>& inverse_masses,
                              const std::vector<Vec3>& x, const std::vector<Vec3>& ways) {
  FibreScratch scratch;
  load_fibres(stage, test::split_of(x), scratch);
  std::vector<Point4> offsets = test::points_of(ways, inverse_masses);
  pull_fibres(stage, scratch, offsets);
  EXPECT_EQ(test::vectors_of(offsets, offsets.size()).back(), Vec3(0, 0, 0));  // the filler
  return test::vectors_of(offsets, x.size());
}

std::vector<Vec3> pulled(const FibreStage& stage, const std::vector<double>& inverse_masses,
                         std::vector<Vec3> x, int times = 1) {
  for (int i = 0; i < times; ++i)
    x = test::sum_of(x, pulled_ways(stage, inverse_masses, x, test::zeros(x.size())));
  return x;
}

double edge_length(const std::vector<Vec3>& x, int i) { return (x[i + 1] - x[i]).norm(); }

double largest_strain(const Chain& chain, const std::vector<Vec3>& x) {
  double largest = 0;
  for (int i = 0; i < chain.edges; ++i)
    largest = std::max(largest, std::abs(edge_length(x, i) / chain.length - 1));
  return largest;
}

TEST(Fibres, AStraightChainIsBackAfterOnePull) {
  const Chain chain = chain_of(100, 0.01, 0);
  for (const double length : {0.013, 0.007}) {
    const std::vector<Vec3> x = pulled(chain.stage, std::vector<double>(101, 5), straight_chain(100, length));
    EXPECT_LT(largest_strain(chain, x), 1e-3 * 0.3);  // a hundred edges leave three of the digits
  }
}

TEST(Fibres, ABentChainIsBackAfterAFewPulls) {
  const Chain chain = chain_of(30, 0.02, 0);
  const std::vector<Vec3> x = stretched_wave(30, 0.02);
  ASSERT_NEAR(largest_strain(chain, x), 0.01, 1e-6);
  EXPECT_LT(largest_strain(chain, pulled(chain.stage, std::vector<double>(31, 1000), x, 4)), 5e-6);
}

TEST(Fibres, BothMomentaAreKept) {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const Chain chain = chain_of(12, 0.1, random.between(0, 0.1));
    const std::vector<double> masses = test::random_masses(13, random);
    const std::vector<Vec3> before = test::shaken(straight_chain(12, 0.1), 0.05, random);
    const std::vector<Vec3> after = pulled(chain.stage, test::inverses(masses), before);
    ASSERT_GT(test::farthest(before, after), 1e-3);
    EXPECT_LT(test::relative_momentum(masses, before, after), 1e-6);
    EXPECT_LT(test::relative_angular_momentum(masses, before, after), 1e-6);
  }
}

TEST(Fibres, PinnedPointsStayAndLengthsAreRestoredBetweenThem) {
  const Chain chain = chain_of(30, 0.02, 0);
  const std::vector<Vec3> start = stretched_wave(30, 0.02);
  std::vector<double> inverse_masses(31, 1000);
  inverse_masses[0] = inverse_masses[17] = 0;
  const std::vector<Vec3> x = pulled(chain.stage, inverse_masses, start, 30);
  EXPECT_EQ(x[0], start[0]);
  EXPECT_EQ(x[17], start[17]);
  EXPECT_LT(largest_strain(chain, x), 1e-5);
}

TEST(Fibres, EdgesBetweenPinnedPointsAreLeft) {
  const std::vector<Vec3> x = straight_chain(3, 0.2);
  for (const double compliance : {0.0, 1e-6})
    EXPECT_EQ(pulled(chain_of(3, 0.1, compliance).stage, std::vector<double>(4, 0), x), x);
}

TEST(Fibres, PointsThatCoincideGiveFiniteResults) {
  const std::vector<Vec3> x(4, Vec3(1, 1, 1));
  EXPECT_TRUE(test::all_finite(pulled(chain_of(3, 0.1, 1e-6).stage, std::vector<double>(4, 1), x)));
  EXPECT_TRUE(test::all_finite(pulled(chain_of(3, 0.1, 0).stage, std::vector<double>(4, 1), x)));
}

// One edge, equal masses m: a spring's implicit step leaves 1 / (1 + 2 k h2 / m) of the excess.
TEST(Fibres, ACompliantEdgeGivesUpItsImplicitShare) {
  const double stiffness = 300, step = 0.01, mass = 0.02;
  const Chain chain = chain_of(1, 1, 1 / (stiffness * step * step));
  const std::vector<Vec3> x = pulled(chain.stage, {1 / mass, 1 / mass}, straight_chain(1, 1.2));
  EXPECT_NEAR(edge_length(x, 0) - 1, 0.2 / (1 + 2 * stiffness * step * step / mass), 1e-6);
}

// Edge i carries the weight of all points below it, and stretches by that over its stiffness.
TEST(Fibres, AHangingChainStretchesByItsWeight) {
  const int edges = 10;
  const double stiffness = 500, mass = 0.05, gravity = 9.81, step = 0.1;
  const Chain chain = chain_of(edges, 0.1, 1 / (stiffness * step * step));
  std::vector<double> inverse_masses(edges + 1, 1 / mass);
  inverse_masses[0] = 0;
  std::vector<Vec3> x = straight_chain(edges, 0.1), fall(edges + 1, Vec3(0, -gravity * step * step, 0));
  fall[0].setZero();
  for (int i = 0; i < 300; ++i) x = test::sum_of(x, pulled_ways(chain.stage, inverse_masses, x, fall));
  for (int i = 0; i < edges; ++i)
    EXPECT_NEAR(edge_length(x, i) - 0.1, (edges - i) * mass * gravity / stiffness, 1e-6);
}

TEST(Fibres, AnEdgeBeyondItsLimitIsBroughtThereWhateverItsStiffness) {
  for (const double compliance : {1e-6, 1.0, 1e6}) {
    const Chain chain = chain_of(20, 0.1, compliance, 0.105);
    const std::vector<Vec3> x = pulled(chain.stage, std::vector<double>(21, 3), straight_chain(20, 0.12));
    for (int i = 0; i < 20; ++i) EXPECT_NEAR(edge_length(x, i), 0.105, 1e-6);
  }
}

TEST(Fibres, BelowTheLimitTheComplianceRules) {
  for (const double strain : {0.03, -0.03}) {
    const std::vector<Vec3> start = straight_chain(20, 0.1 * (1 + strain));
    const std::vector<double> inverse_masses(21, 3);
    const std::vector<Vec3> limited = pulled(chain_of(20, 0.1, 10, 0.105).stage, inverse_masses, start);
    EXPECT_EQ(limited, pulled(chain_of(20, 0.1, 10).stage, inverse_masses, start));
    EXPECT_GT(test::farthest(limited, start), 1e-5);
  }
}

TEST(Fibres, TheLimitIsThatOfTheMaterial) {
  ElasticMaterial material;
  material.strain_limit = 0.04;
  const Sheet sheet = test::sheet_of(test::equilateral_pair(0.1, 0), material);
  const FibreStage stage = build_fibres(sheet, std::vector<double>(5, 1e-9), 0.01);
  const std::vector<Vec3> x =
      pulled(stage, std::vector<double>(4, 1),
             test::moved(sheet.rest_positions, 1.2 * Mat3::Identity(), Vec3::Zero()), 50);
  double longest = 0;
  for (const Edge& edge : sheet.topology.edges)
    longest = std::max(longest, (x[edge.vertices[1]] - x[edge.vertices[0]]).norm());
  EXPECT_NEAR(longest, 0.104, 1e-5);
}

TEST(Fibres, AWholeSheetKeepsItsLinearMomentumAndNearsItsLengths) {
  Random random(2);
  const Sheet sheet = test::sheet_of(make_grid({1, 1}, {11, 11}));
  const FibreStage stage = build_fibres(sheet, std::vector<double>(sheet.topology.edges.size(), 1e9), 0.01);
  const std::vector<double> masses = test::random_masses(121, random);
  const std::vector<Vec3> before = test::moved(sheet.rest_positions, 1.05 * Mat3::Identity(), Vec3::Zero());
  const std::vector<Vec3> after = pulled(stage, test::inverses(masses), before, 20);
  EXPECT_LT(test::relative_momentum(masses, before, after), 1e-6);
  for (const Edge& edge : sheet.topology.edges) {
    const double length = (after[edge.vertices[1]] - after[edge.vertices[0]]).norm();
    EXPECT_NEAR(length / rest_length(sheet, edge), 1, 0.01);
  }
}

}  // namespace
}  // namespace drape
