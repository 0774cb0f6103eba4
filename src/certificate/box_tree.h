#pragma once

#include <algorithm>
#include <vector>

#include "certificate/triangle_meeting.h"

namespace drape {

struct BoundingBox {
  Vec3 lower, upper;
};

BoundingBox box_of(const TrianglePoints& triangle);
BoundingBox hull(const BoundingBox& a, const BoundingBox& b);

inline bool boxes_overlap(const BoundingBox& a, const BoundingBox& b) {
  return (a.lower.array() <= b.upper.array()).all() && (b.lower.array() <= a.upper.array()).all();
}

// No point of one box is nearer than this to one of the other.
inline double squared_box_distance(const BoundingBox& a, const BoundingBox& b) {
  return (a.lower - b.upper).cwiseMax(b.lower - a.upper).cwiseMax(0.0).squaredNorm();
}

// Boxes in a balanced tree: half of them, along the longest side of their centres' box, in each branch. The
// tree is a function of the boxes alone.
class BoxTree {
 public:
  explicit BoxTree(std::vector<BoundingBox> boxes);

  std::size_t size() const { return order_.size(); }
  // The boxes in the order of the leaves, so that neighbours in this order are neighbours in space.
  int item(std::size_t place) const { return order_[place]; }
  const BoundingBox& box(int item) const { return boxes_[item]; }

  // Calls visit(place) for the boxes that overlap `box`.
  template <typename Visit>
  void find_overlapping(const BoundingBox& box, const Visit& visit) const {
    descend(
        0, 0, order_.size(), 0, [&](const BoundingBox& b) { return boxes_overlap(b, box); }, visit);
  }

  // Calls visit(place) for the boxes that are no farther from `box` than `squared_bound()`, which may shrink
  // from call to call, from `first_place` on.
  template <typename Bound, typename Visit>
  void find_near(const BoundingBox& box, std::size_t first_place, const Bound& squared_bound,
                 const Visit& visit) const {
    const auto is_near = [&](const BoundingBox& b) {
      return squared_box_distance(b, box) <= squared_bound();
    };
    descend(0, 0, order_.size(), first_place, is_near, visit);
  }

 private:
  static constexpr std::size_t leaf_size = 4;

  BoundingBox build(std::size_t node, std::size_t begin, std::size_t end);

  // Nodes are numbered as in a heap; their ranges follow from halving.
  template <typename Wanted, typename Visit>
  void descend(std::size_t node, std::size_t begin, std::size_t end, std::size_t first_place,
               const Wanted& wanted, const Visit& visit) const {
    if (end <= first_place || !wanted(nodes_[node])) return;
    if (end - begin <= leaf_size) {
      for (std::size_t place = std::max(begin, first_place); place < end; ++place)
        if (wanted(boxes_[order_[place]])) visit(place);
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    descend(2 * node + 1, begin, middle, first_place, wanted, visit);
    descend(2 * node + 2, middle, end, first_place, wanted, visit);
  }

  std::vector<BoundingBox> boxes_;
  std::vector<BoundingBox> nodes_;
  std::vector<int> order_;
};

}  // namespace drape
