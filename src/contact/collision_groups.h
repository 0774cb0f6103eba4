#pragma once

#include <vector>

#include "contact/active_contacts.h"

namespace drape {

// The paper's collision groups (section 5): contacts that share moving vertices, directly or through others.
// Groups share none and can be resolved at once. A group is resolved in rounds, one after the other, and a
// round in parts that share no moving vertex, at once: a small group is one part, a large one is cut.
struct CollisionGroups {
  std::vector<int> order;                   // contact indices; those of a group of one part keep their order
  std::vector<std::size_t> part_begin{0};   // part p: order[part_begin[p] .. part_begin[p + 1])
  std::vector<std::size_t> round_begin{0};  // round r: parts [round_begin[r] .. round_begin[r + 1])
  std::vector<std::size_t> group_begin{0};  // group g: rounds [group_begin[g] .. group_begin[g + 1])

  std::size_t part_count() const { return part_begin.size() - 1; }
  std::size_t group_count() const { return group_begin.size() - 1; }
};

// `positions`: where the vertices are; parts of large groups are slabs of space.
CollisionGroups group_contacts(const ContactGeometry& geometry, const std::vector<Vec3>& positions,
                               const std::vector<Contact>& contacts);

}  // namespace drape
