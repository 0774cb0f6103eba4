#include <gtest/gtest.h>

#include <algorithm>

#include "contact/spatial_hash.h"
#include "scene.h"

namespace drape {
namespace {

using test::Random;

Box random_box(Random& random, double world, double size) {
  const Vec3 corner = random.vector(world);
  Box box;
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = static_cast<float>(corner[k]);
    box.upper[k] = static_cast<float>(corner[k] + random.between(0, size));
  }
  return box;
}

std::vector<Box> random_boxes(int count, unsigned seed, double world = 1, double size = 0.2) {
  Random random(seed);
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) boxes.push_back(random_box(random, world, size));
  return boxes;
}

std::vector<int> found(const SpatialHash& hash, const Box& query) {
  std::vector<int> items;
  hash.find(query, [&](int item) { items.push_back(item); });
  return items;
}

std::vector<int> sorted(std::vector<int> items) {
  std::sort(items.begin(), items.end());
  return items;
}

std::vector<int> by_brute_force(const std::vector<Box>& items, const Box& query) {
  std::vector<int> overlapping;
  for (int i = 0; i < static_cast<int>(items.size()); ++i)
    if (overlap(items[i], query)) overlapping.push_back(i);
  return overlapping;
}

// All the same items, each once.
void expect_brute_force(const std::vector<Box>& items, const std::vector<Box>& queries, double cell_size) {
  const SpatialHash hash(items, cell_size);
  for (const Box& query : queries) ASSERT_EQ(sorted(found(hash, query)), by_brute_force(items, query));
}

TEST(SpatialHash, FindsWhatBruteForceFindsOnceEach) {
  for (const double cell_size : {0.05, 0.1, 0.3, 1.0, 10.0})
    expect_brute_force(random_boxes(300, 1), random_boxes(300, 2), cell_size);
}

TEST(SpatialHash, LargeItemsAndLargeQueriesAreFoundToo) {
  std::vector<Box> items = random_boxes(200, 3), queries = random_boxes(100, 4);
  for (const std::vector<Box>& large : {random_boxes(20, 5, 1, 2), random_boxes(20, 6, 1, 50)}) {
    items.insert(items.end(), large.begin(), large.end());
    queries.insert(queries.end(), large.begin(), large.end());
  }
  expect_brute_force(items, queries, 0.1);
}

TEST(SpatialHash, ItemsFarFromTheOriginAreFound) {
  expect_brute_force(random_boxes(200, 7, 5e4, 2e3), random_boxes(200, 8, 5e4, 2e3), 0.5e3);
}

TEST(SpatialHash, BoxesThatTouchOverlap) {
  const std::vector<Box> items = {{{0, 0, 0}, {1, 1, 1}}, {{-1, -1, -1}, {0, 0, 0}}};
  const SpatialHash hash(items, 1);
  EXPECT_EQ(sorted(found(hash, {{1, 1, 1}, {2, 2, 2}})), (std::vector{0}));
  EXPECT_EQ(sorted(found(hash, {{0, 0, 0}, {0, 0, 0}})), (std::vector{0, 1}));
}

TEST(SpatialHash, ManyItemsInOnePlaceAreAllFound) {
  const std::vector<Box> items(500, Box{{0.1f, 0.1f, 0.1f}, {0.3f, 0.3f, 0.3f}});
  EXPECT_EQ(found(SpatialHash(items, 0.15), items[0]).size(), 500u);
}

TEST(SpatialHash, AnEmptyBoxFindsNothing) {
  const std::vector<Box> items = random_boxes(100, 9);
  EXPECT_FALSE(overlap(empty_box(), items[0]));
  EXPECT_TRUE(found(SpatialHash(items, 0.1), {{5, 5, 5}, {6, 6, 6}}).empty());
  EXPECT_TRUE(found(SpatialHash({}, 0.1), items[0]).empty());
}

TEST(SpatialHash, ItemsOfACellComeInTheirOrder) {
  const std::vector<Box> items(50, Box{{0.01f, 0.01f, 0.01f}, {0.02f, 0.02f, 0.02f}});
  const std::vector<int> order = found(SpatialHash(items, 1), items[0]);
  EXPECT_EQ(order, sorted(order));
}

TEST(SpatialHash, TheOrderIsThatOfTheLastTime) {
  const std::vector<Box> items = random_boxes(300, 10), queries = random_boxes(50, 11);
  const SpatialHash first(items, 0.1), second(items, 0.1);
  for (const Box& query : queries) EXPECT_EQ(found(first, query), found(second, query));
}

TEST(Box, IncludingGrowsToBoth) {
  Box box = empty_box();
  include(box, {{0, 1, 2}, {1, 2, 3}});
  include(box, {{-1, 1.5f, 0}, {0, 5, 1}});
  EXPECT_EQ(box.lower, (std::array{-1.0f, 1.0f, 0.0f}));
  EXPECT_EQ(box.upper, (std::array{1.0f, 5.0f, 3.0f}));
}

}  // namespace
}  // namespace drape
