#include <gtest/gtest.h>

#include <numeric>

#include "core/parallel.h"

namespace drape {
namespace {

constexpr int thread_counts[] = {1, 2, 4};

TEST(ParallelForEach, VisitsEachIndexOnce) {
  for (const int threads : thread_counts) {
    const ThreadLimit limit(threads);
    for (const std::size_t count : {0u, 1u, 7u, 64u, 1000u}) {
      std::vector<int> visits(count, 0);
      parallel_for_each(count, 7, [&](std::size_t i) { ++visits[i]; });
      EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
  }
}

TEST(ParallelBlocks, DoNotDependOnTheThreads) {
  for (const int threads : thread_counts) {
    const ThreadLimit limit(threads);
    std::vector<std::pair<std::size_t, std::size_t>> ranges(4);
    parallel_blocks(10, 3, [&](std::size_t begin, std::size_t end, std::size_t block) {
      ranges.at(block) = {begin, end};
    });
    EXPECT_EQ(ranges, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 3}, {3, 6}, {6, 9}, {9, 10}}));
  }
}

// A sum of floats put together block by block shows its order in its last bits.
float sum_by_blocks(std::size_t count) {
  std::vector<float> sums;
  parallel_collect(count, 100, sums, [](std::size_t begin, std::size_t end, std::vector<float>& out) {
    float sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += 1.0f / static_cast<float>(i + 1);
    out.push_back(sum);
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0f);
}

TEST(ParallelCollect, SumsHaveTheSameBits) {
  const float expected = [] {
    const ThreadLimit limit(1);
    return sum_by_blocks(100000);
  }();
  for (const int threads : thread_counts) {
    const ThreadLimit limit(threads);
    for (int repeat = 0; repeat < 20; ++repeat) EXPECT_EQ(sum_by_blocks(100000), expected);
  }
}

TEST(ParallelCollect, KeepsTheOrder) {
  for (const int threads : thread_counts) {
    const ThreadLimit limit(threads);
    for (const std::size_t block_size : {1u, 3u, 64u, 5000u}) {
      std::vector<std::size_t> collected = {99, 98};  // what was there is replaced
      parallel_collect(1000, block_size, collected,
                       [](std::size_t begin, std::size_t end, std::vector<std::size_t>& out) {
                         for (std::size_t i = begin; i < end; ++i) out.insert(out.end(), i % 3, i);
                       });
      std::vector<std::size_t> expected;
      for (std::size_t i = 0; i < 1000; ++i) expected.insert(expected.end(), i % 3, i);
      EXPECT_EQ(collected, expected);
    }
  }
}

// Enough to be moved by several threads, with parts of no items and a last one that is smaller.
TEST(ParallelCollect, MuchIsPutTogetherInOrderWhateverWasThereBefore) {
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < 30007; ++i)
    if ((i / 100) % 3 != 1) expected.push_back(i);
  ASSERT_GT(expected.size() * sizeof(std::size_t), 1u << 16);
  for (const int threads : thread_counts) {
    const ThreadLimit limit(threads);
    for (const std::size_t before : {0u, 5u, 40000u}) {
      std::vector<std::size_t> collected(before, 7);
      parallel_collect(30007, 100, collected,
                       [](std::size_t begin, std::size_t end, std::vector<std::size_t>& out) {
                         for (std::size_t i = begin; i < end; ++i)
                           if ((i / 100) % 3 != 1) out.push_back(i);
                       });
      EXPECT_EQ(collected, expected);
    }
  }
}

TEST(ParallelCollect, OfNothing) {
  std::vector<int> collected = {1};
  parallel_collect(0, 16, collected,
                   [](std::size_t, std::size_t, std::vector<int>& out) { out.push_back(2); });
  EXPECT_TRUE(collected.empty());
}

}  // namespace
}  // namespace drape
