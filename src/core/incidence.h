#pragma once

#include <cstddef>
#include <vector>

namespace drape {

// For each point, where it stands in the elements' lists of points put end to end: `slots[begin[v] ..
// begin[v + 1])`, ascending, of point v. Elements write one value a slot, in parallel; each point then adds
// up its own in this order, so that sums have the same bits with any number of threads.
struct Incidence {
  std::vector<std::size_t> begin;
  std::vector<int> slots;
};

// `vertices[slot]` in [0, vertex_count).
Incidence build_incidence(int vertex_count, const std::vector<int>& vertices);

}  // namespace drape
