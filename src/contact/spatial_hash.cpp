#include "contact/spatial_hash.h"

namespace drape {

bool SpatialHash::CellRange::is_large() const {
  constexpr double most_cells = 64;
  double cells = 1;
  for (int k = 0; k < 3; ++k) cells *= static_cast<double>(upper[k]) - lower[k] + 1;
  return !(cells <= most_cells);
}

SpatialHash::SpatialHash(const std::vector<Box>& items, double cell_size)
    : items_(items), inverse_cell_size_(static_cast<float>(1 / cell_size)) {
  std::vector<int> small_items;
  for (int item = 0; item < static_cast<int>(items.size()); ++item)
    (cells_of(items[item]).is_large() ? large_items_ : small_items).push_back(item);
  fill(small_items);
}

void SpatialHash::fill(const std::vector<int>& small_items) {
  std::size_t slots = 16;
  while (slots < 4 * small_items.size()) slots *= 2;
  slot_mask_ = slots - 1;
  slot_begin_.assign(slots + 1, 0);
  for (const int item : small_items)
    for_each_cell(cells_of(items_[item]), [&](const Cell& cell) { ++slot_begin_[slot_of(cell) + 1]; });
  for (std::size_t slot = 0; slot < slots; ++slot) slot_begin_[slot + 1] += slot_begin_[slot];

  entries_.resize(slot_begin_.back());
  std::vector<int> next(slot_begin_.begin(), slot_begin_.end() - 1);
  for (const int item : small_items)
    for_each_cell(cells_of(items_[item]), [&](const Cell& cell) {
      entries_[next[slot_of(cell)]++] = {cell, item};
    });
}

}  // namespace drape
