#include "deformation/sweep_order.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "deformation/coloring.h"

namespace drape {
namespace {

// The longest; of those that are as long, the last: the rows of a grid are numbered along the first, and
// halves of rows would share their cache lines.
int axis_to_cut_across(const std::vector<Vec3>& positions, std::span<const int> vertices) {
  constexpr double as_long = 0.999;
  Vec3 lowest = positions[vertices[0]], highest = lowest;
  for (const int v : vertices) {
    lowest = lowest.cwiseMin(positions[v]);
    highest = highest.cwiseMax(positions[v]);
  }
  const Vec3 extent = highest - lowest;
  int axis = 2;
  while (extent[axis] < as_long * extent.maxCoeff()) --axis;
  return axis;
}

void halve(const std::vector<Vec3>& positions, std::size_t largest_patch, std::span<int> vertices,
           std::vector<int>& patches, int& patch_count) {
  if (vertices.size() <= largest_patch) {
    for (const int v : vertices) patches[v] = patch_count;
    ++patch_count;
    return;
  }
  const int axis = axis_to_cut_across(positions, vertices);
  const std::size_t half = vertices.size() / 2;
  std::nth_element(
      vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(half), vertices.end(),
      [&](int a, int b) { return std::pair(positions[a][axis], a) < std::pair(positions[b][axis], b); });
  halve(positions, largest_patch, vertices.first(half), patches, patch_count);
  halve(positions, largest_patch, vertices.subspan(half), patches, patch_count);
}

using ElementLists = std::vector<std::vector<int>>;

// The elements of each patch that has any: first those that lie within it, then lists of those that reach
// beyond, at the first of their patches. Colours are given in this order: the former share no vertex, and are
// the first colour.
ElementLists elements_of_patches(const std::vector<int>& patches, const std::vector<std::size_t>& begin,
                                 const std::vector<int>& vertices) {
  const std::size_t count =
      patches.empty() ? 0 : static_cast<std::size_t>(*std::max_element(patches.begin(), patches.end())) + 1;
  ElementLists lists(2 * count);
  for (std::size_t e = 0; e + 1 < begin.size(); ++e) {
    int first = patches[vertices[begin[e]]], last = first;
    for (std::size_t i = begin[e]; i < begin[e + 1]; ++i) {
      first = std::min(first, patches[vertices[i]]);
      last = std::max(last, patches[vertices[i]]);
    }
    lists[first == last ? first : count + first].push_back(static_cast<int>(e));
  }
  std::erase_if(lists, [](const std::vector<int>& list) { return list.empty(); });
  return lists;
}

Coloring color_lists(int vertex_count, const ElementLists& lists, const std::vector<std::size_t>& begin,
                     const std::vector<int>& vertices) {
  std::vector<std::size_t> list_begin{0};
  std::vector<int> list_vertices;
  for (const std::vector<int>& list : lists) {
    for (const int e : list)
      list_vertices.insert(list_vertices.end(), vertices.begin() + static_cast<std::ptrdiff_t>(begin[e]),
                           vertices.begin() + static_cast<std::ptrdiff_t>(begin[e + 1]));
    list_begin.push_back(list_vertices.size());
  }
  return color_elements(vertex_count, list_begin, list_vertices);
}

// Colours of the elements of one patch, with its vertices numbered anew: what it takes must not grow with the
// mesh. `numbers` holds -1 for every vertex, before and after.
Coloring color_patch(const std::vector<int>& patch, const std::vector<std::size_t>& begin,
                     const std::vector<int>& vertices, std::vector<int>& numbers) {
  std::vector<std::size_t> own_begin{0};
  std::vector<int> own_vertices, numbered;
  for (const int e : patch) {
    for (std::size_t i = begin[e]; i < begin[e + 1]; ++i) {
      int& number = numbers[vertices[i]];
      if (number < 0) {
        number = static_cast<int>(numbered.size());
        numbered.push_back(vertices[i]);
      }
      own_vertices.push_back(number);
    }
    own_begin.push_back(own_vertices.size());
  }
  for (const int v : numbered) numbers[v] = -1;
  return color_elements(static_cast<int>(numbered.size()), own_begin, own_vertices);
}

// Cuts the rows of one colour into tiles.
void append_tiles(SweepOrder& order) {
  const std::size_t rows = order.elements.size() / Lanes::count;
  while (order.tile_begin.back() < rows)
    order.tile_begin.push_back(std::min(rows, order.tile_begin.back() + SweepOrder::largest_tile));
}

// The elements of one patch, colour by colour, each colour filled up to whole rows.
void append_patch(const std::vector<int>& patch, const Coloring& coloring, SweepOrder& order) {
  for (std::size_t color = 0; color + 1 < coloring.color_begin.size(); ++color) {
    for (std::size_t i = coloring.color_begin[color]; i < coloring.color_begin[color + 1]; ++i)
      order.elements.push_back(patch[coloring.order[i]]);
    while (order.elements.size() % Lanes::count != 0) order.elements.push_back(-1);
    append_tiles(order);
  }
  order.patch_begin.push_back(order.tile_begin.size() - 1);
}

}  // namespace

std::vector<int> vertex_patches(const std::vector<Vec3>& positions, std::size_t largest_patch) {
  std::vector<int> patches(positions.size(), 0), vertices(positions.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  int patch_count = 0;
  if (!positions.empty()) halve(positions, largest_patch, vertices, patches, patch_count);
  return patches;
}

SweepOrder sweep_order(const std::vector<int>& patches, const std::vector<std::size_t>& begin,
                       const std::vector<int>& vertices) {
  const int vertex_count = static_cast<int>(patches.size());
  const ElementLists lists = elements_of_patches(patches, begin, vertices);
  Coloring coloring = color_lists(vertex_count, lists, begin, vertices);
  SweepOrder order{{}, {0}, {0}, std::move(coloring.color_begin)};
  std::vector<int> numbers(patches.size(), -1);
  for (const int list : coloring.order)
    append_patch(lists[list], color_patch(lists[list], begin, vertices, numbers), order);
  return order;
}

}  // namespace drape
