#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "deformation/clusters.h"
#include "mesh/disjoint_sets.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;
using test::sheet_of;
using Cluster = std::array<int, 3>;

std::vector<Cluster> outer_corners_of(const Sheet& sheet) {
  std::vector<int> materials;
  return outer_corners(sheet, materials);
}

// Each triangle has a material of its own, so that a cluster's material names the triangle it is of.
Sheet sheet_of_many_materials(const TriangleMesh& mesh) {
  Sheet sheet = sheet_of(mesh);
  std::iota(sheet.triangle_materials.begin(), sheet.triangle_materials.end(), 0);
  sheet.materials.resize(sheet.triangles.size());
  return sheet;
}

std::vector<Cluster> both_kinds(const Sheet& sheet) {
  std::vector<Cluster> clusters = own_triangles(sheet);
  const std::vector<Cluster> outer = outer_corners_of(sheet);
  clusters.insert(clusters.end(), outer.begin(), outer.end());
  return clusters;
}

Cluster across(const Sheet& sheet, int triangle) {
  Cluster corners;
  for (int k = 0; k < 3; ++k) corners[k] = opposite_vertex(sheet.topology, sheet.triangles, triangle, k);
  return corners;
}

bool is_interior(const Sheet& sheet, int triangle) {
  const Cluster corners = across(sheet, triangle);
  return std::min({corners[0], corners[1], corners[2]}) >= 0;
}

Cluster sorted(Cluster cluster) {
  std::sort(cluster.begin(), cluster.end());
  return cluster;
}

// Pieces that the clusters tie together, of the points that are in any.
std::size_t piece_count(const std::vector<Cluster>& clusters, std::size_t points) {
  DisjointSets sets(static_cast<int>(points));
  std::set<int> covered, pieces;
  for (const auto& [a, b, c] : clusters) {
    sets.join(a, b);
    sets.join(b, c);
    covered.insert({a, b, c});
  }
  for (const int v : covered) pieces.insert(sets.find(v));
  return pieces.size();
}

std::vector<TriangleMesh> many_meshes() {
  return {make_grid({1, 1}, {9, 7}),
          test::jittered_grid(10),
          make_sphere(1, 12, 8),
          test::tetrahedron(),
          test::fan(5),
          make_box({1, 1, 1}),
          make_grid({1, 1}, {2, 2}),
          make_grid({1, 0.05}, {5, 5})};
}

TEST(Clusters, EveryPointIsInAtLeastOneOnEveryMesh) {
  for (const TriangleMesh& mesh : many_meshes()) {
    std::set<int> covered;
    for (const Cluster& cluster : both_kinds(sheet_of(mesh))) covered.insert(cluster.begin(), cluster.end());
    EXPECT_EQ(covered.size(), mesh.positions.size());
  }
}

TEST(Clusters, EveryOuterClusterHasThreePointsAndIsWellShaped) {
  for (const TriangleMesh& mesh : many_meshes())
    for (const auto& [a, b, c] : outer_corners_of(sheet_of(mesh))) {
      EXPECT_TRUE(a != b && b != c && a != c);
      EXPECT_GE(triangle_shape(mesh.positions[a], mesh.positions[b], mesh.positions[c]), 0.1);
    }
}

TEST(Clusters, OwnTrianglesAreOneEach) {
  const TriangleMesh mesh = test::jittered_grid(6);
  EXPECT_EQ(own_triangles(sheet_of(mesh)), mesh.triangles);
}

TEST(Clusters, InsideAGridTheOuterOnesAreTheThreeOppositeCorners) {
  const Sheet sheet = sheet_of_many_materials(make_grid({1, 1}, {8, 8}));
  std::vector<int> triangles;
  const std::vector<Cluster> clusters = outer_corners(sheet, triangles);
  ASSERT_EQ(triangles.size(), clusters.size());
  int interior = 0;
  for (std::size_t i = 0; i < clusters.size(); ++i)
    if (is_interior(sheet, triangles[i])) {
      EXPECT_EQ(sorted(clusters[i]), sorted(across(sheet, triangles[i])));
      ++interior;
    }
  EXPECT_EQ(interior,
            2 * 49 - 26);  // of 28 edges of the boundary, two corners have both of theirs in one triangle
}

TEST(Clusters, ABoundaryTriangleTakesItsTwoOuterCornersAndOneOfItsOwn) {
  const Sheet sheet = sheet_of_many_materials(make_grid({1, 1}, {5, 5}));
  std::vector<int> triangles;
  const std::vector<Cluster> clusters = outer_corners(sheet, triangles);
  int boundary = 0;
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const Cluster outer = across(sheet, triangles[i]);
    if (std::count(outer.begin(), outer.end(), -1) != 1) continue;
    const Triangle& own = sheet.triangles[triangles[i]];
    const auto among = [&](const Cluster& set) {
      return std::count_if(clusters[i].begin(), clusters[i].end(),
                           [&](int v) { return std::count(set.begin(), set.end(), v) > 0; });
    };
    EXPECT_EQ(among(outer), 2);
    EXPECT_EQ(among(own), 1);
    ++boundary;
  }
  EXPECT_GT(boundary, 8);
}

// The gap of the paper's section 4.1: with its clusters alone a cloth falls apart into four lattices.
TEST(Clusters, OuterCornersAloneFallApartAndOwnTrianglesHoldThemTogether) {
  const TriangleMesh mesh = make_grid({1, 1}, {10, 10});
  const Sheet sheet = sheet_of(mesh);
  std::vector<Cluster> paper;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    if (is_interior(sheet, t)) paper.push_back(across(sheet, t));
  EXPECT_EQ(piece_count(paper, mesh.positions.size()), 4u);
  EXPECT_EQ(piece_count(both_kinds(sheet), mesh.positions.size()), 1u);
}

TEST(Clusters, ShapeIsOneForEquilateralAndZeroForCollinearPoints) {
  EXPECT_NEAR(triangle_shape({0, 0, 0}, {2, 0, 0}, {1, std::sqrt(3), 0}), 1, 1e-15);
  EXPECT_EQ(triangle_shape({0, 0, 0}, {1, 0, 0}, {3, 0, 0}), 0);
  EXPECT_EQ(triangle_shape({1, 1, 1}, {1, 1, 1}, {1, 1, 1}), 0);
  EXPECT_NEAR(triangle_shape({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), std::sqrt(3) / 2, 1e-15);
}

double pull_of(double stiffness, double step) {
  const Sheet sheet = sheet_of(test::equilateral_pair(1, 0));
  const std::vector<double> masses(4, 1);
  return build_cluster_stage(sheet, {Cluster{0, 1, 2}}, {stiffness}, masses, step).clusters[0].pull;
}

TEST(Clusters, PullIsThatOfAnImplicitSpring) {
  EXPECT_DOUBLE_EQ(pull_of(1e4, 0.01), 0.5);
  EXPECT_DOUBLE_EQ(pull_of(1, 1e-4), 1e-8 / (1 + 1e-8));
}

TEST(Clusters, PullRisesWithStiffnessAndStepAndStaysBetweenZeroAndOne) {
  double before = 0;
  for (const double stiffness : {1e-3, 1.0, 1e3, 1e6, 1e9}) {
    const double pull = pull_of(stiffness, 0.005);
    EXPECT_GT(pull, before);
    EXPECT_LT(pull, 1);
    EXPECT_GT(pull_of(stiffness, 0.01), pull);
    before = pull;
  }
}

struct Swept {
  ClusterStage stage;
  std::vector<double> masses;
  std::vector<Vec3> before, after;
};

Swept sweep(double stiffness, int pinned = -1) {
  Random random(5);
  const Sheet sheet = sheet_of(test::jittered_grid(8));
  Swept swept;
  swept.masses = test::random_masses(sheet.rest_positions.size(), random);
  const std::vector<double> all(sheet.triangles.size(), stiffness);
  swept.stage = build_cluster_stage(sheet, own_triangles(sheet), all, swept.masses, 0.01);
  swept.before = test::shaken(sheet.rest_positions, 0.03, random);
  swept.after = swept.before;
  std::vector<double> inverse_masses = test::inverses(swept.masses);
  if (pinned >= 0) inverse_masses[pinned] = 0;
  pull_clusters(swept.stage, inverse_masses, swept.after);
  return swept;
}

// sum over clusters of the potential's sum m |goal - x|2.
double misfit(const Swept& swept, const std::vector<Vec3>& x) {
  double sum = 0;
  for (const TriangleCluster& cluster : swept.stage.clusters) {
    const auto& [a, b, c] = cluster.vertices;
    const auto d = match_displacements(cluster.rest, x[a], x[b], x[c]);
    for (int i = 0; i < 3; ++i) sum += swept.masses[cluster.vertices[i]] * d[i].squaredNorm();
  }
  return sum;
}

TEST(Clusters, EachClusterKeepsItsTrianglesMassesAndShape) {
  const Swept swept = sweep(1);
  ASSERT_EQ(swept.stage.clusters.size(), 98u);
  for (const TriangleCluster& cluster : swept.stage.clusters) {
    const double total = swept.masses[cluster.vertices[0]] + swept.masses[cluster.vertices[1]] +
                         swept.masses[cluster.vertices[2]];
    EXPECT_DOUBLE_EQ(cluster.rest.share2, swept.masses[cluster.vertices[1]] / total);
    EXPECT_DOUBLE_EQ(cluster.rest.share3, swept.masses[cluster.vertices[2]] / total);
  }
}

TEST(Clusters, ASweepKeepsLinearMomentumAndLowersTheMisfit) {
  const Swept swept = sweep(3e4);
  EXPECT_LT(test::relative_momentum(swept.masses, swept.before, swept.after), 1e-14);
  EXPECT_LT(misfit(swept, swept.after), 0.5 * misfit(swept, swept.before));
}

TEST(Clusters, PinnedPointsStay) {
  const Swept swept = sweep(3e4, 20);
  EXPECT_EQ(swept.after[20], swept.before[20]);
  EXPECT_NE(swept.after[21], swept.before[21]);
}

TEST(Clusters, AnElasticSheetMovedRigidlyStays) {
  Random random(6);
  const Sheet sheet = sheet_of(make_sphere(0.5, 12, 9));
  const std::vector<double> masses = test::random_masses(sheet.rest_positions.size(), random);
  const std::vector<Cluster> clusters = both_kinds(sheet);
  const std::vector<double> stiffness(clusters.size(), 1e6);
  const ClusterStage stage = build_cluster_stage(sheet, clusters, stiffness, masses, 0.01);
  const std::vector<Vec3> before = test::moved(sheet.rest_positions, random.rotation(), random.vector());
  std::vector<Vec3> after = before;
  pull_clusters(stage, test::inverses(masses), after);
  EXPECT_LT(test::farthest(before, after), 1e-13);
}

}  // namespace
}  // namespace drape
