#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vector.h"

namespace drape {

struct Contact;

// What holds a contact in a step.
struct ContactImpulse {
  double along_normal;  // kg m, never negative
  Vec3 friction;        // kg m: across the normal
};

// What held a contact in the step before; with which contact it was (as in Contact).
struct HeldImpulse {
  std::array<int, 2> place;
  std::array<int, 4> vertices;
  std::int64_t kind;  // as wide as leaves no gap
  ContactImpulse impulse;
};
static_assert(sizeof(HeldImpulse) == 64, "no gaps: hashed and written as it lies in memory");

// Those of the contacts that something held, in the order of the contacts.
std::vector<HeldImpulse> hold_impulses(const std::vector<Contact>& contacts,
                                       const std::vector<ContactImpulse>& impulses);

// What held each of the contacts in the step before; zeros where nothing did.
std::vector<ContactImpulse> recall_impulses(const std::vector<HeldImpulse>& held,
                                            const std::vector<Contact>& contacts);

}  // namespace drape
