#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vector.h"

namespace drape {

struct Contact;

// What a contact keeps from one step to the next.
struct ContactMemory {
  double impulse;             // kg m: what held it along the normal, never negative
  Vec3 friction_impulse;      // kg m: across the normal
  std::int64_t paused_steps;  // for so many steps more it is not pushed apart; as wide as leaves no gap
};

// With which contact it was (as in Contact).
struct RememberedContact {
  std::array<int, 2> place;
  std::array<int, 4> vertices;
  std::int64_t kind;
  ContactMemory memory;
};
static_assert(sizeof(RememberedContact) == 72, "no gaps: hashed and written as it lies in memory");

// The contacts that something holds or that are not to be pushed, in their order; `memories` are of each.
std::vector<RememberedContact> remember(const std::vector<Contact>& contacts,
                                        const std::vector<ContactMemory>& memories);

// What each of the contacts keeps of the step before; zeros where it keeps nothing.
std::vector<ContactMemory> recall(const std::vector<RememberedContact>& remembered,
                                  const std::vector<Contact>& contacts);

}  // namespace drape
