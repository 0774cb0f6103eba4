#pragma once

// The only file that includes oneTBB. Work is cut into blocks of a fixed size that does not depend on the
// number of threads, so a result put together block by block has the same bits with any number of threads.

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace drape {

// While it lives, parallel loops use at most `threads` threads (0: one a core).
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads)
      : control_(oneapi::tbb::global_control::max_allowed_parallelism,
                 threads > 0 ? static_cast<std::size_t>(threads)
                             : oneapi::tbb::global_control::active_value(
                                   oneapi::tbb::global_control::max_allowed_parallelism)) {}

 private:
  oneapi::tbb::global_control control_;
};

// Calls body(begin, end, block) for each block of `block_size` indices of [0, count). Blocks must not write
// to the same memory. A block should be some ten microseconds of work, and a loop of some thousand points
// should have eight or more: with two or three, threads mostly wait for each other.
template <typename Body>
void parallel_blocks(std::size_t count, std::size_t block_size, const Body& body) {
  const std::size_t blocks = (count + block_size - 1) / block_size;
  const auto run = [&](std::size_t block) {
    body(block * block_size, std::min(count, (block + 1) * block_size), block);
  };
  if (blocks <= 1) {
    if (blocks == 1) run(0);
    return;
  }
  oneapi::tbb::parallel_for(
      oneapi::tbb::blocked_range<std::size_t>(0, blocks, 1),
      [&](const auto& range) {
        for (std::size_t block = range.begin(); block != range.end(); ++block) run(block);
      },
      oneapi::tbb::simple_partitioner());
}

// Calls body(i) for each i of [0, count).
template <typename Body>
void parallel_for_each(std::size_t count, std::size_t block_size, const Body& body) {
  parallel_blocks(count, block_size, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

// The concatenation, in order, of what each block produces: body(begin, end, out) appends to `out`.
template <typename Item, typename Body>
void parallel_collect(std::size_t count, std::size_t block_size, std::vector<Item>& result,
                      const Body& body) {
  std::vector<std::vector<Item>> parts((count + block_size - 1) / block_size);
  parallel_blocks(count, block_size, [&](std::size_t begin, std::size_t end, std::size_t block) {
    body(begin, end, parts[block]);
  });
  std::vector<std::size_t> begin(parts.size() + 1, 0);
  for (std::size_t p = 0; p < parts.size(); ++p) begin[p + 1] = begin[p] + parts[p].size();
  result.resize(begin.back());
  constexpr std::size_t little = 1 << 16;  // bytes: they are moved before another thread has come
  const std::size_t parts_a_block =
      begin.back() * sizeof(Item) > little ? 4 : std::max<std::size_t>(parts.size(), 1);
  parallel_for_each(parts.size(), parts_a_block, [&](std::size_t p) {
    std::move(parts[p].begin(), parts[p].end(), result.begin() + static_cast<std::ptrdiff_t>(begin[p]));
  });
}

}  // namespace drape
