#include "contact/held_impulses.h"

#include <algorithm>

#include "contact/active_contacts.h"
#include "core/parallel.h"

namespace drape {
namespace {

constexpr std::size_t block = 512;

bool is_same(const HeldImpulse& held, const Contact& contact) {
  return held.kind == contact.kind && held.vertices == contact.vertices;
}

using Iterator = std::vector<HeldImpulse>::const_iterator;

// The contact's impulse, if it is among those of its place from `at` on: these are few.
Iterator find(const Contact& contact, Iterator at, Iterator end) {
  for (; at != end && at->place == contact.place; ++at)
    if (is_same(*at, contact)) return at;
  return end;
}

}  // namespace

std::vector<HeldImpulse> hold_impulses(const std::vector<Contact>& contacts,
                                       const std::vector<ContactImpulse>& impulses) {
  std::vector<HeldImpulse> held;
  parallel_collect(contacts.size(), block, held,
                   [&](std::size_t begin, std::size_t end, std::vector<HeldImpulse>& out) {
                     for (std::size_t i = begin; i < end; ++i) {
                       const Contact& contact = contacts[i];
                       if (impulses[i].along_normal > 0)
                         out.push_back({contact.place, contact.vertices, contact.kind, impulses[i]});
                     }
                   });
  return held;
}

// Both are in the order of their places, and for the same place in that of their primitives, whichever are
// there: one walk through both finds all.
std::vector<ContactImpulse> recall_impulses(const std::vector<HeldImpulse>& held,
                                            const std::vector<Contact>& contacts) {
  const auto precedes = [](const HeldImpulse& a, const std::array<int, 2>& b) { return a.place < b; };
  std::vector<ContactImpulse> impulses(contacts.size(), ContactImpulse{0, Vec3::Zero()});
  parallel_blocks(contacts.size(), block, [&](std::size_t begin, std::size_t end, std::size_t) {
    Iterator at = std::lower_bound(held.begin(), held.end(), contacts[begin].place, precedes);
    for (std::size_t i = begin; i < end; ++i) {
      while (at != held.end() && at->place < contacts[i].place) ++at;
      const Iterator found = find(contacts[i], at, held.end());
      if (found == held.end()) continue;
      impulses[i] = found->impulse;
      at = found + 1;
    }
  });
  return impulses;
}

}  // namespace drape
