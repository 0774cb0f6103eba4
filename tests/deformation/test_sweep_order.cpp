#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "deformation/bending.h"
#include "deformation/sweep_order.h"
#include "sheets.h"

namespace drape {
namespace {

using Elements = std::vector<std::vector<int>>;

struct Case {
  std::vector<Vec3> positions;
  std::vector<int> patches;
  Elements elements;  // negative vertices are absent
};

Case triangles_of(const TriangleMesh& mesh, std::size_t largest_patch) {
  Case result{mesh.positions, vertex_patches(mesh.positions, largest_patch), {}};
  for (const Triangle& t : mesh.triangles) result.elements.emplace_back(t.begin(), t.end());
  return result;
}

Case bending_clusters_of(const TriangleMesh& mesh, std::size_t largest_patch) {
  Case result{mesh.positions, vertex_patches(mesh.positions, largest_patch), {}};
  const Sheet sheet = test::sheet_of(mesh);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const std::array<int, 6> corners = bending_corners(sheet, t);
    result.elements.emplace_back(corners.begin(), corners.end());
  }
  return result;
}

std::vector<Case> many_cases() {
  return {
      triangles_of(make_grid({1, 1}, {30, 25}), 60),         triangles_of(test::jittered_grid(20), 1300),
      bending_clusters_of(make_grid({1, 1}, {30, 25}), 100), bending_clusters_of(test::jittered_grid(25), 40),
      bending_clusters_of(make_sphere(1, 20, 12), 30),       triangles_of(test::tetrahedron(), 1)};
}

std::vector<int> vertices_of_row(const Case& c, const SweepOrder& order, std::size_t row) {
  std::vector<int> vertices;
  for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
    const int element = order.elements[Lanes::count * row + lane];
    if (element < 0) continue;
    for (const int v : c.elements[element])
      if (v >= 0) vertices.push_back(v);
  }
  return vertices;
}

RowRange rows_of_patch(const SweepOrder& order, std::size_t patch) {
  return {order.tile_begin[order.patch_begin[patch]], order.tile_begin[order.patch_begin[patch + 1]]};
}

std::set<int> vertices_of_patch(const Case& c, const SweepOrder& order, std::size_t patch) {
  std::set<int> vertices;
  const RowRange rows = rows_of_patch(order, patch);
  for (std::size_t row = rows.first; row < rows.end; ++row)
    for (const int v : vertices_of_row(c, order, row)) vertices.insert(v);
  return vertices;
}

TEST(VertexPatches, AreNoLargerThanAskedAndNoSmallerThanHalfOfThat) {
  for (const std::size_t largest : {1u, 7u, 100u, 1300u}) {
    const std::vector<int> patches = vertex_patches(test::jittered_grid(45).positions, largest);
    std::vector<std::size_t> sizes(
        static_cast<std::size_t>(*std::max_element(patches.begin(), patches.end())) + 1);
    for (const int patch : patches) ++sizes[patch];
    EXPECT_LE(*std::max_element(sizes.begin(), sizes.end()), largest);
    EXPECT_GE(2 * *std::min_element(sizes.begin(), sizes.end()), largest);
  }
}

TEST(VertexPatches, AreCompact) {
  const std::vector<Vec3> positions = make_grid({1, 1}, {32, 32}).positions;
  const std::vector<int> patches = vertex_patches(positions, 64);
  for (std::size_t a = 0; a < positions.size(); ++a)
    for (std::size_t b = 0; b < positions.size(); ++b)
      if (patches[a] == patches[b]) {
        EXPECT_LT((positions[a] - positions[b]).norm(), 0.33);
      }
}

// Threads that sweep the halves of a grid so do not share its rows' cache lines.
TEST(VertexPatches, ASquareGridIsHalvedBetweenRows) {
  const std::vector<int> patches = vertex_patches(make_grid({1, 1}, {32, 32}).positions, 512);
  for (int v = 0; v < 1024; ++v) EXPECT_EQ(patches[v], v / 512);
}

TEST(VertexPatches, PointsThatCoincideAreCutAsWell) {
  const std::vector<int> patches = vertex_patches(test::zeros(10), 4);
  EXPECT_EQ(std::set<int>(patches.begin(), patches.end()).size(), 4u);
  EXPECT_TRUE(vertex_patches({}, 4).empty());
}

TEST(SweepOrder, HasEveryElementOnce) {
  for (const Case& c : many_cases()) {
    std::vector<int> elements = sweep_order(c.patches, c.elements).elements, all(c.elements.size());
    std::erase(elements, -1);
    std::sort(elements.begin(), elements.end());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(elements, all);
  }
}

TEST(SweepOrder, NoTwoElementsOfATileShareAVertex) {
  for (const Case& c : many_cases()) {
    const SweepOrder order = sweep_order(c.patches, c.elements);
    for (std::size_t tile = 0; tile + 1 < order.tile_begin.size(); ++tile) {
      std::vector<int> vertices;
      for (std::size_t row = order.tile_begin[tile]; row < order.tile_begin[tile + 1]; ++row)
        for (const int v : vertices_of_row(c, order, row)) vertices.push_back(v);
      EXPECT_EQ(std::set<int>(vertices.begin(), vertices.end()).size(), vertices.size());
      EXPECT_FALSE(vertices.empty());
    }
  }
}

TEST(SweepOrder, NoTwoPatchesOfAColorShareAVertex) {
  for (const Case& c : many_cases()) {
    const SweepOrder order = sweep_order(c.patches, c.elements);
    for (std::size_t color = 0; color + 1 < order.color_begin.size(); ++color) {
      std::set<int> seen;
      for (std::size_t patch = order.color_begin[color]; patch < order.color_begin[color + 1]; ++patch)
        for (const int v : vertices_of_patch(c, order, patch)) EXPECT_TRUE(seen.insert(v).second);
    }
  }
}

TEST(SweepOrder, RowsAndPatchesAreCountedToTheirEnd) {
  for (const Case& c : many_cases()) {
    const SweepOrder order = sweep_order(c.patches, c.elements);
    EXPECT_EQ(order.elements.size() % Lanes::count, 0u);
    EXPECT_EQ(order.elements.size(), order.row_count() * Lanes::count);
    EXPECT_EQ(order.patch_begin.back() + 1, order.tile_begin.size());
    EXPECT_EQ(order.color_begin.back(), order.patch_count());
  }
}

TEST(SweepOrder, AnElementGoesToTheFirstPatchAmongItsVertices) {
  const Case c = triangles_of(make_grid({1, 1}, {20, 20}), 50);
  const SweepOrder order = sweep_order(c.patches, c.elements);
  const auto first_patch = [&](int element) {
    int first = c.patches[c.elements[element][0]];
    for (const int v : c.elements[element]) first = std::min(first, c.patches[v]);
    return first;
  };
  for (std::size_t patch = 0; patch < order.patch_count(); ++patch) {
    std::set<int> found;
    const RowRange rows = rows_of_patch(order, patch);
    for (std::size_t i = Lanes::count * rows.first; i < Lanes::count * rows.end; ++i)
      if (order.elements[i] >= 0) found.insert(first_patch(order.elements[i]));
    EXPECT_EQ(found.size(), 1u);
  }
}

// Eight patches, which threads take at once; the rest is little.
TEST(SweepOrder, WhatLiesWithinPatchesIsTheFirstColor) {
  const Case c = triangles_of(make_grid({1, 1}, {78, 78}), 1300);
  const SweepOrder order = sweep_order(c.patches, c.elements);
  EXPECT_EQ(order.color_begin[1], 8u);
  const RowRange rows{0, order.tile_begin[order.patch_begin[8]]};
  EXPECT_GT(static_cast<double>(rows.end), 0.9 * static_cast<double>(order.row_count()));
  for (std::size_t patch = 0; patch < 8; ++patch) {
    std::set<int> patches;
    for (const int v : vertices_of_patch(c, order, patch)) patches.insert(c.patches[v]);
    EXPECT_EQ(patches.size(), 1u);
  }
}

TEST(SweepOrder, IsTheSameEveryTime) {
  for (const Case& c : many_cases()) {
    const SweepOrder first = sweep_order(c.patches, c.elements);
    const SweepOrder second = sweep_order(c.patches, c.elements);
    EXPECT_EQ(first.elements, second.elements);
    EXPECT_EQ(first.tile_begin, second.tile_begin);
    EXPECT_EQ(first.patch_begin, second.patch_begin);
    EXPECT_EQ(first.color_begin, second.color_begin);
  }
}

TEST(SweepOrder, LargePatchesHaveFewFillers) {
  const Case c = triangles_of(make_grid({1, 1}, {60, 60}), 1300);
  const std::vector<int> elements = sweep_order(c.patches, c.elements).elements;
  EXPECT_LT(std::count(elements.begin(), elements.end(), -1), 0.05 * static_cast<double>(elements.size()));
}

TEST(SweepOrder, NothingMakesNoRows) {
  const SweepOrder order = sweep_order(test::one_patch(5), Elements{});
  EXPECT_EQ(order.row_count(), 0u);
  EXPECT_EQ(order.patch_count(), 0u);
  sweep(order, [](const RowRange&) { FAIL(); });
}

TEST(Sweep, CallsEveryRowOnce) {
  const Case c = triangles_of(make_grid({1, 1}, {30, 30}), 40);
  const SweepOrder order = sweep_order(c.patches, c.elements);
  std::vector<int> calls(order.row_count(), 0);
  sweep(order, [&](const RowRange& rows) {
    for (std::size_t row = rows.first; row < rows.end; ++row) ++calls[row];
  });
  EXPECT_EQ(calls, std::vector<int>(order.row_count(), 1));
}

TEST(ForEachLane, NamesElementsInOrderAndAFillerForEachPatch) {
  const Case c = triangles_of(make_grid({1, 1}, {30, 30}), 40);
  const SweepOrder order = sweep_order(c.patches, c.elements);
  std::vector<int> elements(order.elements.size(), -2);
  std::vector<int> fillers(order.elements.size());
  for_each_lane(order, 900, [&](int element, std::size_t row, int lane, int filler) {
    elements[Lanes::count * row + static_cast<std::size_t>(lane)] = element;
    fillers[Lanes::count * row + static_cast<std::size_t>(lane)] = filler;
  });
  EXPECT_EQ(elements, order.elements);
  EXPECT_EQ(std::set<int>(fillers.begin(), fillers.end()).size(), order.patch_count());
  EXPECT_EQ(*std::min_element(fillers.begin(), fillers.end()), 900);
}

}  // namespace
}  // namespace drape
