#pragma once

#include <cstddef>
#include <vector>

#include "core/lanes.h"
#include "core/parallel.h"
#include "core/vector.h"

namespace drape {

// An order for Gauss-Seidel sweeps over elements that is quick and gives the same bits for any number of
// threads. Elements lie in rows of eight (one element a lane), rows in tiles; the elements of a tile share no
// vertex, so that a kernel may take a tile phase by phase: each phase alone keeps a core busy, where a whole
// row at once mostly waits for its own square roots and divisions. Tiles lie in patches, which fit a core's
// cache; patches lie in colours, of which no two patches share a vertex and so can be swept at once.
struct SweepOrder {
  static constexpr std::size_t largest_tile = 4;  // rows

  // Eight a row; -1: a filler, where a colour of a patch has none left. Stages drop them when they are built.
  std::vector<int> elements;
  std::vector<std::size_t> tile_begin;   // rows of tile t: [tile_begin[t] .. tile_begin[t + 1])
  std::vector<std::size_t> patch_begin;  // tiles of patch p: [patch_begin[p] .. patch_begin[p + 1])
  std::vector<std::size_t> color_begin;  // patches of colour c: [color_begin[c] .. color_begin[c + 1])

  std::size_t row_count() const { return tile_begin.back(); }
  std::size_t patch_count() const { return patch_begin.size() - 1; }
};

// Rows of one tile.
struct RowRange {
  std::size_t first, end;
};

// A patch for each vertex: the halves of halves of the positions, cut across their longest extent, until none
// holds more than `largest_patch`.
std::vector<int> vertex_patches(const std::vector<Vec3>& positions, std::size_t largest_patch);

// The vertices of element e are vertices[begin[e] .. begin[e + 1]). Elements that lie within a patch of
// vertices are one patch of the order; those that reach beyond go to one of their own, by the first patch
// among theirs: so all of the former, which is most, have one colour.
SweepOrder sweep_order(const std::vector<int>& patches, const std::vector<std::size_t>& begin,
                       const std::vector<int>& vertices);

// The same for elements that are arrays of vertices; negative ones count as absent.
template <typename Elements>
SweepOrder sweep_order(const std::vector<int>& patches, const Elements& elements) {
  std::vector<std::size_t> begin{0};
  std::vector<int> vertices;
  for (const auto& element : elements) {
    for (const int vertex : element)
      if (vertex >= 0) vertices.push_back(vertex);
    begin.push_back(vertices.size());
  }
  return sweep_order(patches, begin, vertices);
}

// Calls body(rows) for every tile: those of a patch in order, patches of a colour at once.
template <typename Body>
void sweep(const SweepOrder& order, const Body& body) {
  for (std::size_t color = 0; color + 1 < order.color_begin.size(); ++color) {
    const std::size_t first = order.color_begin[color];
    parallel_for_each(order.color_begin[color + 1] - first, 1, [&](std::size_t i) {
      for (std::size_t tile = order.patch_begin[first + i]; tile < order.patch_begin[first + i + 1]; ++tile)
        body(RowRange{order.tile_begin[tile], order.tile_begin[tile + 1]});
    });
  }
}

// Fillers of a patch have vertices of their own, behind those of the mesh, so that threads do not meet there;
// and three of them, so that they make a triangle as sound as any.
constexpr std::size_t fillers_a_patch = 3;

// Calls body(element, row, lane, first_filler_vertex) for every lane of every row, element -1 for fillers.
template <typename Body>
void for_each_lane(const SweepOrder& order, std::size_t vertex_count, const Body& body) {
  parallel_for_each(order.patch_count(), 1, [&](std::size_t patch) {
    const std::size_t first = order.tile_begin[order.patch_begin[patch]];
    for (std::size_t row = first; row < order.tile_begin[order.patch_begin[patch + 1]]; ++row)
      for (int lane = 0; lane < Lanes::count; ++lane)
        body(order.elements[row * Lanes::count + static_cast<std::size_t>(lane)], row, lane,
             static_cast<int>(vertex_count + fillers_a_patch * patch));
  });
}

}  // namespace drape
