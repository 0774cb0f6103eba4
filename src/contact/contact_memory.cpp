#include "contact/contact_memory.h"

#include <algorithm>

#include "contact/active_contacts.h"
#include "core/parallel.h"

namespace drape {
namespace {

constexpr std::size_t block = 256;

// Instead of `==`, which calls memcmp for so little.
template <std::size_t count>
bool equal(const std::array<int, count>& a, const std::array<int, count>& b) {
  for (std::size_t i = 0; i < count; ++i)
    if (a[i] != b[i]) return false;
  return true;
}

bool is_same(const RememberedContact& remembered, const Contact& contact) {
  return remembered.kind == contact.kind && equal(remembered.vertices, contact.vertices);
}

using Iterator = std::vector<RememberedContact>::const_iterator;

// The contact, if it is among those of its place from `at` on: these are few.
Iterator find(const Contact& contact, Iterator at, Iterator end) {
  for (; at != end && equal(at->place, contact.place); ++at)
    if (is_same(*at, contact)) return at;
  return end;
}

}  // namespace

std::vector<RememberedContact> remember(const std::vector<Contact>& contacts,
                                        const std::vector<ContactMemory>& memories) {
  std::vector<RememberedContact> remembered;
  parallel_collect(contacts.size(), block, remembered,
                   [&](std::size_t begin, std::size_t end, std::vector<RememberedContact>& out) {
                     for (std::size_t i = begin; i < end; ++i) {
                       const ContactMemory& memory = memories[i];
                       if (memory.impulse > 0 || memory.paused_steps > 0)
                         out.push_back({contacts[i].place, contacts[i].vertices, contacts[i].kind, memory});
                     }
                   });
  return remembered;
}

// Both are in the order of their places, and for the same place in that of their primitives, whichever are
// there: one walk through both finds all.
std::vector<ContactMemory> recall(const std::vector<RememberedContact>& remembered,
                                  const std::vector<Contact>& contacts) {
  std::vector<ContactMemory> memories(contacts.size(), ContactMemory{0, Vec3::Zero(), 0});
  const auto precedes = [](const RememberedContact& a, const std::array<int, 2>& b) { return a.place < b; };
  parallel_blocks(contacts.size(), block, [&](std::size_t begin, std::size_t end, std::size_t) {
    Iterator at = std::lower_bound(remembered.begin(), remembered.end(), contacts[begin].place, precedes);
    for (std::size_t i = begin; i < end; ++i) {
      while (at != remembered.end() && at->place < contacts[i].place) ++at;
      const Iterator found = find(contacts[i], at, remembered.end());
      if (found == remembered.end()) continue;
      memories[i] = found->memory;
      at = found + 1;
    }
  });
  return memories;
}

}  // namespace drape
