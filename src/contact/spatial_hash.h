#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/vector.h"

namespace drape {

// An axis-aligned box, rounded outward to floats.
struct Box {
  std::array<float, 3> lower, upper;
};

inline Box empty_box() {
  constexpr float far = std::numeric_limits<float>::max();
  return {{far, far, far}, {-far, -far, -far}};
}

inline bool overlap(const Box& a, const Box& b) {
  return a.lower[0] <= b.upper[0] && b.lower[0] <= a.upper[0] && a.lower[1] <= b.upper[1] &&
         b.lower[1] <= a.upper[1] && a.lower[2] <= b.upper[2] && b.lower[2] <= a.upper[2];
}

inline void include(Box& box, const Box& other) {
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = std::min(box.lower[k], other.lower[k]);
    box.upper[k] = std::max(box.upper[k], other.upper[k]);
  }
}

// Spatial hashing (Teschner et al. 2003, Optimized Spatial Hashing for Collision Detection of Deformable
// Objects): each item is entered into all cells of a uniform grid that its box touches; cells are hashed into
// a table, which is filled by a counting sort, so that its order is that of the items. Each entry keeps its
// exact cell: items of another cell in the same slot are told apart.
class SpatialHash {
 public:
  SpatialHash(const std::vector<Box>& items, double cell_size);

  // report(item) for each item whose box overlaps `query`, once each.
  template <typename Report>
  void find(const Box& query, const Report& report) const;

 private:
  using Cell = std::array<int, 3>;
  struct Entry {
    Cell cell;
    int item;
  };
  struct CellRange {
    Cell lower, upper;
    bool is_large() const;
  };

  Cell cell_of(const std::array<float, 3>& point) const {
    const auto index = [&](float value) { return static_cast<int>(std::floor(value * inverse_cell_size_)); };
    return {index(point[0]), index(point[1]), index(point[2])};
  }
  std::size_t slot_of(const Cell& cell) const {
    return (static_cast<std::uint32_t>(cell[0]) * 73856093u ^
            static_cast<std::uint32_t>(cell[1]) * 19349663u ^
            static_cast<std::uint32_t>(cell[2]) * 83492791u) &
           slot_mask_;
  }
  CellRange cells_of(const Box& box) const { return {cell_of(box.lower), cell_of(box.upper)}; }
  template <typename Visit>
  static void for_each_cell(const CellRange& range, const Visit& visit) {
    for (int i = range.lower[0]; i <= range.upper[0]; ++i)
      for (int j = range.lower[1]; j <= range.upper[1]; ++j)
        for (int k = range.lower[2]; k <= range.upper[2]; ++k) visit(Cell{i, j, k});
  }
  void fill(const std::vector<int>& small_items);

  const std::vector<Box>& items_;
  float inverse_cell_size_;
  std::size_t slot_mask_ = 0;
  std::vector<int> slot_begin_;
  std::vector<Entry> entries_;
  std::vector<int> large_items_;  // in too many cells to be entered: compared with every query
};

template <typename Report>
void SpatialHash::find(const Box& query, const Report& report) const {
  const CellRange range = cells_of(query);
  if (range.is_large()) {
    for (std::size_t item = 0; item < items_.size(); ++item)
      if (overlap(items_[item], query)) report(static_cast<int>(item));
    return;
  }
  for (const int item : large_items_)
    if (overlap(items_[item], query)) report(item);
  for_each_cell(range, [&](const Cell& cell) {
    const std::size_t slot = slot_of(cell);
    for (int e = slot_begin_[slot]; e < slot_begin_[slot + 1]; ++e) {
      const Entry& entry = entries_[e];
      const Box& box = items_[entry.item];
      if (entry.cell != cell || !overlap(box, query)) continue;
      // Both are in every cell of their overlap: the one of its lower corner reports them.
      const std::array<float, 3> corner = {std::max(box.lower[0], query.lower[0]),
                                           std::max(box.lower[1], query.lower[1]),
                                           std::max(box.lower[2], query.lower[2])};
      if (cell_of(corner) == cell) report(entry.item);
    }
  });
}

}  // namespace drape
