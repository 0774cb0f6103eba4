#pragma once

#include <vector>

#include "contact/active_contacts.h"

namespace drape {

// The paper's collision groups (section 5): contacts that share moving vertices, directly or through others,
// one group after another. A group's contacts keep their order.
struct CollisionGroups {
  std::vector<int> order;                // contact indices
  std::vector<std::size_t> group_begin;  // group g: order[group_begin[g] .. group_begin[g + 1])
};
CollisionGroups group_contacts(const ContactGeometry& geometry, const std::vector<Contact>& contacts);

// Moves the step's end positions x so that every contact keeps its target: iterated, local,
// momentum-conserving pulls (after Spillmann and Teschner 2008), as projected Gauss-Seidel on the accumulated
// impulses, which the contacts hold afterwards, with Coulomb friction against the way since `start`. A group
// is settled when a sweep moves none of its contacts by more than a hundredth of `thickness` (metres). What
// the pulls bring nearer to each other is the next step's to find, and the fail-safe's to keep apart until
// then.
void resolve_contacts(const ContactGeometry& geometry, const CollisionGroups& groups,
                      const std::vector<Vec3>& start, double thickness, std::vector<Contact>& contacts,
                      std::vector<Vec3>& x);

// Afterwards: moves overlapping sides a little way apart, positions only. Returns the impulse of each contact
// in kg m.
std::vector<double> push_apart(const ContactGeometry& geometry, const CollisionGroups& groups,
                               const std::vector<Contact>& contacts, std::vector<Vec3>& x);

// What of the vertices' ways from `start` to `end` was such a push and must not go into the velocities, in m:
// of each contact as much as its sides have really parted. Where something pushes them together again, the
// push is no way, and to take it from the velocity would leave one with which nothing moves.
std::vector<Vec3> pushed_ways(const ContactGeometry& geometry, const std::vector<Contact>& contacts,
                              const std::vector<double>& push_impulses, const std::vector<Vec3>& start,
                              const std::vector<Vec3>& end);

}  // namespace drape
