#include <gtest/gtest.h>

#include <algorithm>

#include "core/parallel.h"
#include "deformation/averaged_model.h"
#include "deformation/clusters.h"
#include "deformation/fibres.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;
using test::sheet_of;

AveragedModel model_of(const Sheet& sheet, const std::vector<int>& pins = {}, double alpha = 1) {
  std::vector<char> pinned(sheet.rest_positions.size(), 0);
  for (const int v : pins) pinned[v] = 1;
  return build_averaged_model(sheet, lumped_masses(sheet), pinned, alpha);
}

std::vector<Vec3> pulled(const AveragedModel& model, std::vector<Vec3> x) {
  AveragedScratch scratch;
  pull_averaged(model, scratch, x);
  return x;
}

// The same form with the triangle clusters of section 4.1 only. A point that is in none of them stays.
AveragedModel without_fibres(const Sheet& sheet) {
  AveragedModel model = model_of(sheet);
  model.fibre_begin.resize(1);
  model.vertices.resize(model.fibre_begin[0]);
  const std::vector<double> masses = lumped_masses(sheet);
  model.incidence = build_incidence(static_cast<int>(masses.size()), model.vertices);
  for (std::size_t v = 0; v < masses.size(); ++v)
    model.weights[v] =
        masses[v] / static_cast<double>(model.incidence.begin[v + 1] - model.incidence.begin[v]);
  for (std::size_t c = 0; c < model.rest.size(); ++c) {
    std::array<Vec3, 3> points;
    std::array<double, 3> weights;
    for (int i = 0; i < 3; ++i) {
      points[i] = sheet.rest_positions[model.vertices[3 * c + i]];
      weights[i] = model.weights[model.vertices[3 * c + i]];
    }
    model.rest[c] = match_constants(points, weights);
  }
  return model;
}

// A cloth that moves by MHTG05's integration: x* = x + h v + h2 g, then x**, then v = (x** - x) / h.
struct Cloth {
  Sheet sheet;
  AveragedModel model;
  std::vector<double> masses;
  std::vector<Vec3> x, v;
  AveragedScratch scratch{};

  Cloth(const TriangleMesh& mesh, const std::vector<int>& pins)
      : sheet(sheet_of(mesh)),
        model(model_of(sheet, pins)),
        masses(lumped_masses(sheet)),
        x(sheet.rest_positions),
        v(x.size(), Vec3::Zero()) {}

  void advance(double step, const Vec3& gravity) {
    const std::vector<Vec3> start = x;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!model.pinned[i]) x[i] += step * (v[i] + step * gravity);
    pull_averaged(model, scratch, x);
    for (std::size_t i = 0; i < x.size(); ++i) v[i] = (x[i] - start[i]) / step;
  }

  double kinetic_energy() const {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += 0.5 * masses[i] * v[i].squaredNorm();
    return sum;
  }

  Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < x.size(); ++i) sum += masses[i] * v[i];
    return sum;
  }

  Vec3 angular_momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < x.size(); ++i) sum += masses[i] * x[i].cross(v[i]);
    return sum;
  }
};

Cloth spinning_cloth(double noise) {
  Random random(6);
  Cloth cloth(make_grid({1, 1}, {9, 9}), {});
  for (std::size_t i = 0; i < cloth.x.size(); ++i)
    cloth.v[i] = Vec3(0.3, 1, 0.2).normalized().cross(cloth.x[i]) + random.vector(noise);
  return cloth;
}

TEST(AveragedModel, AClothAtRestStaysWhereverItIsMoved) {
  Random random(1);
  for (const TriangleMesh& mesh : {test::jittered_grid(9), make_sphere(0.4, 12, 9), test::tetrahedron()}) {
    const Sheet sheet = sheet_of(mesh);
    const std::vector<Vec3> x = test::moved(sheet.rest_positions, random.rotation(), random.vector());
    EXPECT_LT(test::farthest(x, pulled(model_of(sheet), x)), 1e-13);
  }
}

// The sweeps of section 4.2 written out again, one list a fibre.
std::vector<Vec3> fibre_displacements(const std::vector<Vec3>& x, const std::vector<double>& lengths,
                                      const std::vector<double>& weights) {
  const std::size_t n = x.size();
  std::vector<Vec3> forth = x, back = x, displacements(n);
  for (std::size_t i = 1; i < n; ++i)
    forth[i] = forth[i - 1] + lengths[i - 1] * (x[i] - forth[i - 1]).normalized();
  for (std::size_t i = n - 1; i > 0; --i)
    back[i - 1] = back[i] + lengths[i - 1] * (x[i - 1] - back[i]).normalized();
  Vec3 sum = Vec3::Zero();
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    displacements[i] = (forth[i] + back[i]) / 2 - x[i];
    sum += weights[i] * displacements[i];
    total += weights[i];
  }
  for (Vec3& displacement : displacements) displacement -= sum / total;
  return displacements;
}

TEST(AveragedModel, APointMovesByAlphaTimesTheMeanOfItsGoals) {
  Random random(2);
  const Sheet sheet = sheet_of(test::jittered_grid(7));
  const AveragedModel model = model_of(sheet, {}, 0.7);
  const std::vector<Vec3> x = test::shaken(sheet.rest_positions, 0.03, random);
  std::vector<Vec3> sums(x.size(), Vec3::Zero());
  std::vector<int> materials, counts(x.size(), 0);
  const auto clusters = outer_corners(sheet, materials);
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    const auto& [i, j, k] = clusters[c];
    const auto goals = match_displacements(model.rest[c], x[i], x[j], x[k]);
    for (int corner = 0; corner < 3; ++corner) {
      sums[clusters[c][corner]] += goals[corner];
      ++counts[clusters[c][corner]];
    }
  }
  for (const std::vector<int>& fibre : trace_fibres(sheet)) {
    std::vector<Vec3> points;
    std::vector<double> lengths, weights;
    for (std::size_t i = 0; i < fibre.size(); ++i) {
      points.push_back(x[fibre[i]]);
      weights.push_back(model.weights[fibre[i]]);
      if (i > 0)
        lengths.push_back((sheet.rest_positions[fibre[i]] - sheet.rest_positions[fibre[i - 1]]).norm());
    }
    const std::vector<Vec3> displacements = fibre_displacements(points, lengths, weights);
    for (std::size_t i = 0; i < fibre.size(); ++i) {
      sums[fibre[i]] += displacements[i];
      ++counts[fibre[i]];
    }
  }
  const std::vector<Vec3> after = pulled(model, x);
  for (std::size_t v = 0; v < x.size(); ++v) {
    EXPECT_LT((after[v] - (x[v] + 0.7 * sums[v] / counts[v])).norm(), 1e-15);
    EXPECT_NEAR(model.weights[v], lumped_masses(sheet)[v] / counts[v], 1e-16);
  }
}

TEST(AveragedModel, PinnedPointsStayAndHoldTheirNeighbours) {
  Random random(3);
  const Sheet sheet = sheet_of(make_grid({1, 1}, {11, 11}));
  const AveragedModel held = model_of(sheet, {0, 10}), free = model_of(sheet);
  const std::vector<Vec3> x = test::shaken(sheet.rest_positions, 0.03, random);
  const std::vector<Vec3> after = pulled(held, x);
  EXPECT_EQ(after[0], x[0]);
  EXPECT_EQ(after[10], x[10]);
  EXPECT_NEAR(held.weights[10] / free.weights[10], 1e4, 1e-8);
  EXPECT_NE(after[1], pulled(free, x)[1]);
}

TEST(AveragedModel, PointsThatCoincideGetGoalsThatAreFinite) {
  const Sheet sheet = sheet_of(test::jittered_grid(5));
  const std::vector<Vec3> x(25, Vec3(1, 2, 3));
  EXPECT_EQ(pulled(model_of(sheet), x), x);
}

TEST(AveragedModel, TheSameBitsWithAnyNumberOfThreads) {
  Random random(4);
  const Sheet sheet = sheet_of(test::jittered_grid(60));
  const AveragedModel model = model_of(sheet, {0, 59});
  const std::vector<Vec3> start = test::shaken(sheet.rest_positions, 0.02, random);
  std::vector<std::vector<Vec3>> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    results.push_back(pulled(model, pulled(model, start)));
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

TEST(AveragedModel, APassKeepsLinearMomentum) {
  Random random(5);
  const Sheet sheet = sheet_of(test::jittered_grid(12));
  const std::vector<double> masses = test::random_masses(144, random);
  const AveragedModel model = build_averaged_model(sheet, masses, std::vector<char>(144, 0), 0.8);
  const std::vector<Vec3> x = test::shaken(sheet.rest_positions, 0.03, random);
  EXPECT_LT(test::relative_momentum(masses, x, pulled(model, x)), 1e-14);
}

// About x*, no cluster's goals have a torque, and weights of m_i / M_i keep it so in the average; the sweeps
// of a fibre that is not straight have one.
TEST(AveragedModel, ClustersKeepAngularMomentumAboutWhatTheySeeAndFibresDoNot) {
  Random random(7);
  const Sheet sheet = sheet_of(test::jittered_grid(12));
  const std::vector<double> masses = lumped_masses(sheet);
  const std::vector<Vec3> x = test::shaken(sheet.rest_positions, 0.03, random);
  EXPECT_LT(test::relative_angular_momentum(masses, x, pulled(without_fibres(sheet), x)), 1e-14);
  EXPECT_GT(test::relative_angular_momentum(masses, x, pulled(model_of(sheet), x)), 1e-3);
}

// What follows measures where the paper's own form falls short.

// On a regular grid no outer corner is an odd number of cells from another, along rows or columns: of the
// four lattices, each is free to leave the three others, and only clusters at the boundary, which the paper
// does not describe, and fibres notice.
TEST(AveragedModel, OuterCornersLetFourLatticesPartAndOnlyFibresPullThemBack) {
  constexpr int side = 16;
  const Sheet sheet = sheet_of(make_grid({1, 1}, {side, side}));
  const Vec3 shift(0.01, 0.02, -0.01);
  std::vector<Vec3> x = sheet.rest_positions;
  for (int row = 0; row < side; row += 2)
    for (int column = 0; column < side; column += 2) x[row * side + column] += shift;
  const std::vector<Vec3> by_clusters = pulled(without_fibres(sheet), x), by_all = pulled(model_of(sheet), x);
  for (int row = 3; row < side - 3; ++row)
    for (int column = 3; column < side - 3; ++column) {
      const int v = row * side + column;
      EXPECT_LT((by_clusters[v] - x[v]).norm(), 1e-15);
      if (row % 2 == 0 && column % 2 == 0) {
        EXPECT_LT((by_all[v] - x[v]).dot(shift), -1e-5);
      }
    }
}

// A rigid spin of 1 rad/s loses 4 % of its angular momentum and 9 % of its energy in ten seconds at 5 ms.
TEST(AveragedModel, FreeFlightKeepsMomentumButLosesAngularMomentum) {
  Cloth cloth = spinning_cloth(0);
  for (Vec3& velocity : cloth.v) velocity += Vec3(1, 2, 3);
  for (std::size_t i = 0; i < cloth.x.size(); ++i) cloth.x[i] -= 5 * Vec3(1, 2, 3);
  const Vec3 momentum = cloth.momentum(), angular_momentum = cloth.angular_momentum();
  for (int n = 0; n < 2000; ++n) cloth.advance(0.005, Vec3::Zero());
  EXPECT_LT((cloth.momentum() - momentum).norm(), 1e-12 * momentum.norm());
  const double lost = (cloth.angular_momentum() - angular_momentum).norm() / angular_momentum.norm();
  EXPECT_GT(lost, 0.02);
  EXPECT_LT(lost, 0.08);
}

double largest_energy_gain(Cloth cloth, double seconds, double step) {
  const double first = cloth.kinetic_energy();
  double most = first;
  for (int n = 0; n < seconds / step; ++n) {
    cloth.advance(step, Vec3::Zero());
    most = std::max(most, cloth.kinetic_energy());
  }
  return most / first;
}

// The motion is chaotic; over seeds, spins, steps of 2 and 5 ms and alpha, its energy grew 3 to 500 times in
// 60 s, without any force. The clusters have no part in that.
TEST(AveragedModel, FibreSweepsInjectEnergyAndClustersDoNot) {
  Cloth cloth = spinning_cloth(0.3);
  EXPECT_GT(largest_energy_gain(cloth, 10, 0.002), 10);
  cloth.model = without_fibres(cloth.sheet);
  EXPECT_LE(largest_energy_gain(cloth, 10, 0.002), 1);
}

// 99th percentile of the edges' stretch.
double high_stretch(const Cloth& cloth) {
  std::vector<double> stretch;
  for (const Edge& edge : cloth.sheet.topology.edges) {
    const auto& [a, b] = edge.vertices;
    const double rest = (cloth.sheet.rest_positions[a] - cloth.sheet.rest_positions[b]).norm();
    stretch.push_back((cloth.x[a] - cloth.x[b]).norm() / rest - 1);
  }
  std::sort(stretch.begin(), stretch.end());
  return stretch[stretch.size() * 99 / 100];
}

// One pass in each step of 5 ms: 1 m x 1 m of 32 x 32 points that hangs from two corners. After five seconds
// the 99th percentile of stretch is 38 %, and points still fly about at 4 m/s.
TEST(AveragedModel, AHangingSheetStretchesByTensOfPercentAndNeverComesToRest) {
  Cloth cloth(make_grid({1, 1}, {32, 32}), {0, 31});
  for (int n = 0; n < 1000; ++n) cloth.advance(0.005, {0, -9.81, 0});
  double fastest = 0;
  for (const Vec3& velocity : cloth.v) fastest = std::max(fastest, velocity.norm());
  EXPECT_GT(high_stretch(cloth), 0.15);
  EXPECT_GT(fastest, 1);
}

}  // namespace
}  // namespace drape
