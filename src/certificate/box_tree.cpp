#include "certificate/box_tree.h"

#include <numeric>

namespace drape {

BoundingBox box_of(const TrianglePoints& t) {
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

BoundingBox hull(const BoundingBox& a, const BoundingBox& b) {
  return {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)};
}

static Vec3 doubled_centre(const BoundingBox& box) { return box.lower + box.upper; }

BoxTree::BoxTree(std::vector<BoundingBox> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  std::size_t level = 1;
  while (level * leaf_size < order_.size()) level *= 2;
  nodes_.resize(2 * level);
  if (!order_.empty()) build(0, 0, order_.size());
}

BoundingBox BoxTree::build(std::size_t node, std::size_t begin, std::size_t end) {
  const auto at = [&](std::size_t place) { return order_.begin() + static_cast<std::ptrdiff_t>(place); };
  if (end - begin <= leaf_size) {
    nodes_[node] = boxes_[order_[begin]];
    for (std::size_t i = begin + 1; i < end; ++i) nodes_[node] = hull(nodes_[node], boxes_[order_[i]]);
    return nodes_[node];
  }
  BoundingBox centres{doubled_centre(boxes_[order_[begin]]), doubled_centre(boxes_[order_[begin]])};
  for (std::size_t i = begin + 1; i < end; ++i)
    centres = hull(centres, {doubled_centre(boxes_[order_[i]]), doubled_centre(boxes_[order_[i]])});
  int axis = 0;
  (centres.upper - centres.lower).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(at(begin), at(middle), at(end), [&](int a, int b) {
    const double place_a = doubled_centre(boxes_[a])[axis], place_b = doubled_centre(boxes_[b])[axis];
    return place_a != place_b ? place_a < place_b : a < b;
  });
  const BoundingBox left = build(2 * node + 1, begin, middle), right = build(2 * node + 2, middle, end);
  return nodes_[node] = hull(left, right);
}

}  // namespace drape
