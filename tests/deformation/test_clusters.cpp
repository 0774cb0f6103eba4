#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "deformation/clusters.h"
#include "mesh/disjoint_sets.h"
#include "sheets.h"

namespace drape {
namespace {

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
  sheet.warp_directions.resize(sheet.triangles.size(), Vec3(1, 0, 0));
  return sheet;
}

std::vector<Cluster> both_kinds(const Sheet& sheet) {
  std::vector<Cluster> clusters = sheet.triangles;
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

}  // namespace
}  // namespace drape
