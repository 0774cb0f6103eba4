#pragma once

#include <cstddef>
#include <vector>

namespace drape {

// Elements put into classes ("colours") of which no two elements share a vertex: a class can be swept in
// parallel, and Gauss-Seidel over the classes in order gives the same bits with any number of threads.
struct Coloring {
  std::vector<int> order;                // element indices, colour by colour, ascending in each
  std::vector<std::size_t> color_begin;  // colour c: order[color_begin[c] .. color_begin[c + 1])
};

// Greedy: each colour takes, in order, every element left that touches none it has taken. The vertices of
// element e are vertices[begin[e] .. begin[e + 1]).
Coloring color_elements(int vertex_count, const std::vector<std::size_t>& begin,
                        const std::vector<int>& vertices);

// The same for elements that are arrays of vertices.
template <typename Elements>
Coloring color_elements(int vertex_count, const Elements& elements) {
  std::vector<std::size_t> begin{0};
  std::vector<int> vertices;
  for (const auto& element : elements) {
    vertices.insert(vertices.end(), element.begin(), element.end());
    begin.push_back(vertices.size());
  }
  return color_elements(vertex_count, begin, vertices);
}

}  // namespace drape
