#include <gtest/gtest.h>

#include <numeric>

#include "core/parallel.h"
#include "deformation/elastic_model.h"
#include "deformation/momentum.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;
using test::sheet_of;

constexpr double step = 1.0 / 240;

ElasticModel model_of(const Sheet& sheet, const std::vector<int>& pins = {}) {
  std::vector<char> pinned(sheet.rest_positions.size(), 0);
  for (const int v : pins) pinned[v] = 1;
  return build_elastic_model(sheet, lumped_masses(sheet), pinned, step);
}

std::vector<Vec3> pulled(const ElasticModel& model, std::vector<Vec3> x, int times = 1) {
  FibreScratch scratch;
  for (int i = 0; i < times; ++i) pull_to_goals(model, scratch, x);
  return x;
}

TEST(Sheet, PointsShareTheMassOfTheirTriangles) {
  const Sheet sheet = sheet_of(make_grid({2, 3}, {9, 7}), {.density = 0.3});
  const std::vector<double> masses = lumped_masses(sheet);
  EXPECT_NEAR(std::accumulate(masses.begin(), masses.end(), 0.0), 0.3 * 6, 1e-13);
  EXPECT_NEAR(masses[4 * 9 + 4], 0.3 * 0.25 * 0.5, 1e-15);  // inside: one cell
  EXPECT_NEAR(masses[1], masses[4 * 9 + 4] / 2, 1e-15);     // on an edge: half of one
}

TEST(Sheet, MassFollowsTheMaterialOfEachTriangle) {
  Sheet sheet = sheet_of(test::equilateral_pair(1, 0));
  sheet.materials = {{.density = 1}, {.density = 10}};
  sheet.triangle_materials = {0, 1};
  const std::vector<double> masses = lumped_masses(sheet);
  EXPECT_NEAR(masses[3] / masses[2], 10, 1e-13);
  EXPECT_NEAR(masses[0] / masses[2], 11, 1e-13);
  EXPECT_NEAR(rest_area(sheet, 0), std::sqrt(3) / 4, 1e-15);
}

TEST(ElasticModel, TheSameBitsWithAnyNumberOfThreads) {
  Random random(1);
  const Sheet sheet = sheet_of(test::jittered_grid(60));
  const ElasticModel model = model_of(sheet, {0, 59});
  const std::vector<Vec3> start = test::shaken(sheet.rest_positions, 0.02, random);
  std::vector<std::vector<Vec3>> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    results.push_back(pulled(model, start, 3));
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

TEST(ElasticModel, TheSweepsOfClustersHaveTheSameBitsWithAnyNumberOfThreads) {
  Random random(2);
  const Sheet sheet = sheet_of(test::jittered_grid(60));
  const ElasticModel model = model_of(sheet);
  const std::vector<Vec3> start = test::shaken(sheet.rest_positions, 0.02, random);
  std::vector<std::vector<Vec3>> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    results.push_back(start);
    for (int sweep = 0; sweep < 5; ++sweep)
      pull_clusters(model.own_triangles, model.inverse_masses, results.back());
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

TEST(ElasticModel, AClothAtRestStaysWhereverItIsMoved) {
  Random random(3);
  for (const TriangleMesh& mesh : {test::jittered_grid(9), make_sphere(0.4, 12, 9), test::tetrahedron()}) {
    const Sheet sheet = sheet_of(mesh);
    const std::vector<Vec3> x = test::moved(sheet.rest_positions, random.rotation(), random.vector());
    EXPECT_LT(test::farthest(x, pulled(model_of(sheet), x)), 1e-12);
  }
}

TEST(ElasticModel, APullKeepsLinearMomentum) {
  Random random(4);
  const Sheet sheet = sheet_of(test::jittered_grid(12));
  const std::vector<Vec3> x = test::shaken(sheet.rest_positions, 0.03, random);
  EXPECT_LT(test::relative_momentum(lumped_masses(sheet), x, pulled(model_of(sheet), x)), 1e-13);
}

TEST(ElasticModel, PinnedPointsStayAndHoldTheirNeighbours) {
  Random random(5);
  const Sheet sheet = sheet_of(make_grid({1, 1}, {11, 11}));
  const ElasticModel model = model_of(sheet, {0, 10});
  EXPECT_EQ(model.inverse_masses[0], 0);
  EXPECT_EQ(model.inverse_masses[10], 0);
  EXPECT_NEAR(model.inverse_masses[5], 1 / lumped_masses(sheet)[5], 1e-9);
  const std::vector<Vec3> x = test::shaken(sheet.rest_positions, 0.03, random);
  const std::vector<Vec3> after = pulled(model, x);
  EXPECT_EQ(after[0], x[0]);
  EXPECT_EQ(after[10], x[10]);
  EXPECT_NE(after[5], x[5]);
}

TEST(ElasticModel, PinnedPointsWeighTenThousandfoldInTheirClusters) {
  const Sheet sheet = sheet_of(test::equilateral_pair(1, 0));
  const ElasticModel model = model_of(sheet, {2});  // triangle 0, 2, 1: masses 2, 1, 2 in units of the least
  for (const TriangleCluster& cluster : model.own_triangles.clusters)
    if (cluster.vertices[1] == 2) {
      EXPECT_NEAR(cluster.rest.share2, 1e4 / (1e4 + 4), 1e-12);
    }
}

// 1/2 s sum m |goal - x|2 at a strain of e in all directions is the membrane's k e2 times the area.
TEST(ElasticModel, AStretchedSheetStoresTheEnergyOfAMembrane) {
  const double stretch_stiffness = 3000, strain = 1e-3;
  const Sheet sheet = sheet_of(make_grid({1, 2}, {9, 9}), {.stretch_stiffness = stretch_stiffness});
  const ElasticModel model = model_of(sheet);
  const std::vector<double> masses = lumped_masses(sheet);
  double energy = 0;
  for (const TriangleCluster& cluster : model.own_triangles.clusters) {
    const auto& [a, b, c] = cluster.vertices;
    const std::vector<Vec3>& x = sheet.rest_positions;
    const double scale = 1 + strain;
    const auto d = match_displacements<double>(cluster.rest, scale * x[a], scale * x[b], scale * x[c]);
    const double stiffness = cluster.pull / (1 - cluster.pull) / (step * step);
    for (int i = 0; i < 3; ++i) energy += 0.5 * stiffness * masses[cluster.vertices[i]] * d[i].squaredNorm();
  }
  EXPECT_NEAR(energy, stretch_stiffness * strain * strain * 2, 1e-9 * energy);
}

// In free flight a shaken cloth settles: its energy of motion only goes down, by far.
TEST(ElasticModel, FreeFlightGainsNoEnergyAndKeepsBothMomenta) {
  Random random(6);
  const Sheet sheet = sheet_of(make_grid({1, 1}, {9, 9}));
  const ElasticModel model = model_of(sheet);
  const std::vector<double> masses = lumped_masses(sheet);
  FreePiece piece;
  piece.vertices.resize(masses.size());
  std::iota(piece.vertices.begin(), piece.vertices.end(), 0);

  const Vec3 spin(0.3, 1, 0.2);
  std::vector<Vec3> x = sheet.rest_positions, v;
  for (const Vec3& point : x) v.push_back(spin.cross(point) + random.vector(0.3));
  const auto angular_momentum = [&] {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < x.size(); ++i) sum += masses[i] * x[i].cross(v[i]);
    return sum;
  };
  const auto kinetic_energy = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += 0.5 * masses[i] * v[i].squaredNorm();
    return sum;
  };
  const Vec3 at_first = angular_momentum();
  const double most = kinetic_energy();
  FibreScratch scratch;
  for (int n = 0; n < 480; ++n) {
    const std::vector<Vec3> start = x;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += step * v[i];
    const std::vector<Vec3> predicted = x;
    pull_to_goals(model, scratch, x);
    restore_angular_momentum(piece, masses, start, predicted, x);
    for (std::size_t i = 0; i < x.size(); ++i) v[i] = (x[i] - start[i]) / step;
    ASSERT_LE(kinetic_energy(), most * (1 + 1e-9)) << "step " << n;
  }
  EXPECT_LT((angular_momentum() - at_first).norm(), 1e-10 * at_first.norm());
  EXPECT_LT(kinetic_energy(), 0.7 * most);
}

}  // namespace
}  // namespace drape
