#include "core/incidence.h"

#include <numeric>

namespace drape {

// Counting sort by point.
Incidence build_incidence(int vertex_count, const std::vector<int>& vertices) {
  Incidence incidence;
  incidence.begin.assign(vertex_count + 1, 0);
  for (const int vertex : vertices) ++incidence.begin[vertex + 1];
  std::partial_sum(incidence.begin.begin(), incidence.begin.end(), incidence.begin.begin());
  std::vector<std::size_t> next(incidence.begin.begin(), incidence.begin.end() - 1);
  incidence.slots.resize(vertices.size());
  for (int slot = 0; slot < static_cast<int>(vertices.size()); ++slot)
    incidence.slots[next[vertices[slot]]++] = slot;
  return incidence;
}

}  // namespace drape
