#pragma once

#include <vector>

#include "contact/active_contacts.h"

namespace drape {

// One of the paper's collision groups (section 5): contacts that share moving vertices, directly or through
// others. A large one is cut into parts that share none, and into what joins these.
struct CollisionGroup {
  std::vector<std::size_t> part_begin;  // part p: order[part_begin[p] .. part_begin[p + 1])
  std::size_t joints_begin, end;        // what is of no one part: order[joints_begin .. end)
};

struct CollisionGroups {
  std::vector<int> order;  // contact indices; those of a group without parts stay in their order
  std::vector<CollisionGroup> groups;
};

// `positions`: where the vertices are; parts of large groups are slabs of space.
CollisionGroups group_contacts(const ContactGeometry& geometry, const std::vector<Vec3>& positions,
                               const std::vector<Contact>& contacts);

}  // namespace drape
