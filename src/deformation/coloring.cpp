#include "deformation/coloring.h"

#include <numeric>

namespace drape {

Coloring color_elements(int vertex_count, const std::vector<std::size_t>& begin,
                        const std::vector<int>& vertices) {
  Coloring coloring{{}, {0}};
  std::vector<int> taken_by_color(static_cast<std::size_t>(vertex_count), -1);
  std::vector<int> left(begin.size() - 1), next;
  std::iota(left.begin(), left.end(), 0);
  for (int color = 0; !left.empty(); ++color) {
    next.clear();
    for (const int element : left) {
      bool free = true;
      for (std::size_t i = begin[element]; i < begin[element + 1]; ++i)
        free = free && taken_by_color[vertices[i]] != color;
      if (free)
        coloring.order.push_back(element);
      else
        next.push_back(element);
      for (std::size_t i = begin[element]; free && i < begin[element + 1]; ++i)
        taken_by_color[vertices[i]] = color;
    }
    coloring.color_begin.push_back(coloring.order.size());
    left.swap(next);
  }
  return coloring;
}

}  // namespace drape
