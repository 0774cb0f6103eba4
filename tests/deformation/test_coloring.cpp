#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "deformation/coloring.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;
using Elements = std::vector<std::vector<int>>;

Elements random_elements(int count, int vertices, int most_corners, unsigned seed) {
  Random random(seed);
  Elements elements;
  for (int e = 0; e < count; ++e) {
    std::set<int> corners;
    const int size = 1 + random.below(most_corners);
    while (static_cast<int>(corners.size()) < size) corners.insert(random.below(vertices));
    elements.emplace_back(corners.begin(), corners.end());
  }
  return elements;
}

std::vector<int> members(const Coloring& coloring, std::size_t color) {
  return {coloring.order.begin() + static_cast<std::ptrdiff_t>(coloring.color_begin[color]),
          coloring.order.begin() + static_cast<std::ptrdiff_t>(coloring.color_begin[color + 1])};
}

template <typename Elements>
bool apart_in_each_color(const Coloring& coloring, const Elements& elements) {
  for (std::size_t color = 0; color + 1 < coloring.color_begin.size(); ++color) {
    std::set<int> seen;
    for (const int e : members(coloring, color))
      for (const int v : elements[e])
        if (!seen.insert(v).second) return false;
  }
  return true;
}

TEST(Coloring, NoTwoElementsOfAColorShareAVertex) {
  const Elements elements = random_elements(400, 300, 6, 1);
  EXPECT_TRUE(apart_in_each_color(color_elements(300, elements), elements));
  const TriangleMesh grid = make_grid({1, 1}, {20, 17});
  EXPECT_TRUE(apart_in_each_color(color_elements(340, grid.triangles), grid.triangles));
}

TEST(Coloring, EveryElementHasOneColor) {
  const Coloring coloring = color_elements(300, random_elements(400, 300, 6, 2));
  std::vector<int> sorted = coloring.order, all(400);
  std::sort(sorted.begin(), sorted.end());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);
  EXPECT_EQ(coloring.color_begin.front(), 0u);
  EXPECT_EQ(coloring.color_begin.back(), 400u);
}

TEST(Coloring, ElementsOfAColorAscendAndNoColorIsEmpty) {
  const Coloring coloring = color_elements(300, random_elements(400, 300, 6, 3));
  for (std::size_t color = 0; color + 1 < coloring.color_begin.size(); ++color) {
    const std::vector<int> elements = members(coloring, color);
    EXPECT_FALSE(elements.empty());
    EXPECT_TRUE(std::is_sorted(elements.begin(), elements.end()));
  }
}

TEST(Coloring, EachColorTakesAllThatFits) {
  // 0-1, 1-2, 2-3, 3-4: the even ones first, the odd ones then.
  const Coloring coloring = color_elements(5, Elements{{0, 1}, {1, 2}, {2, 3}, {3, 4}});
  EXPECT_EQ(coloring.order, (std::vector{0, 2, 1, 3}));
  EXPECT_EQ(coloring.color_begin, (std::vector<std::size_t>{0, 2, 4}));
}

TEST(Coloring, DisjointElementsNeedOneColor) {
  const Coloring coloring = color_elements(6, Elements{{4, 5}, {0, 1}, {2, 3}});
  EXPECT_EQ(coloring.order, (std::vector{0, 1, 2}));
  EXPECT_EQ(coloring.color_begin.size(), 2u);
}

TEST(Coloring, ElementsThatAllMeetNeedAColorEach) {
  const Coloring coloring = color_elements(4, Elements{{0, 1}, {0, 2}, {0, 3}});
  EXPECT_EQ(coloring.color_begin, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(Coloring, NoElementsNeedNoColor) {
  const Coloring coloring = color_elements(3, Elements{});
  EXPECT_TRUE(coloring.order.empty());
  EXPECT_EQ(coloring.color_begin.size(), 1u);
}

// An element has up to 6 others at each of its 3 vertices: a greedy colouring needs no more than these and
// one.
TEST(Coloring, AGridNeedsFewColors) {
  const TriangleMesh grid = make_grid({1, 1}, {30, 30});
  EXPECT_LE(color_elements(900, grid.triangles).color_begin.size(), 14u);
}

}  // namespace
}  // namespace drape
