#include "contact/held_impulses.h"

#include <gtest/gtest.h>

#include "contact/active_contacts.h"

namespace drape {
namespace {

Contact contact_of(const std::array<int, 2>& place, int kind, int vertex) {
  Contact contact{};
  contact.place = place;
  contact.kind = kind;
  contact.vertices = {vertex, vertex + 1, vertex + 2, vertex + 3};
  return contact;
}

// Contacts of many pairs of patches, in order; each has an impulse of its own, but for every fifth.
struct Step {
  std::vector<Contact> contacts;
  std::vector<ContactImpulse> impulses;

  Step() {
    for (int i = 0; i < 3000; ++i) {
      contacts.push_back(contact_of({i / 30, i / 10 % 3}, i % 10 < 5 ? 0 : 1, i));
      impulses.push_back({i % 5 == 0 ? 0.0 : i, Vec3(0, i, 1)});
    }
  }
};

template <typename Item>
std::vector<Item> all_but_each(std::size_t nth, const std::vector<Item>& items) {
  std::vector<Item> some;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (i % nth != 0) some.push_back(items[i]);
  return some;
}

TEST(HeldImpulses, ComeBackToTheContactsThatTheyHeldWhicheverHaveComeAndGone) {
  const Step step;
  const std::vector<HeldImpulse> held =
      hold_impulses(all_but_each(7, step.contacts), all_but_each(7, step.impulses));
  const std::vector<Contact> now = all_but_each(11, step.contacts);
  const std::vector<ContactImpulse> recalled = recall_impulses(held, now);
  ASSERT_EQ(recalled.size(), now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    const int number = now[i].vertices[0];
    const bool was_held = number % 7 != 0 && number % 5 != 0;
    EXPECT_EQ(recalled[i].along_normal, was_held ? number : 0) << number;
    EXPECT_EQ(recalled[i].friction, was_held ? Vec3(0, number, 1) : Vec3(0, 0, 0)) << number;
  }
}

TEST(HeldImpulses, AContactOfTheSameVerticesAndAnotherKindIsAnother) {
  const std::vector<HeldImpulse> held = hold_impulses({contact_of({2, 1}, 0, 5)}, {{1, Vec3::Zero()}});
  EXPECT_EQ(recall_impulses(held, {contact_of({2, 1}, 1, 5)})[0].along_normal, 0);
  EXPECT_EQ(recall_impulses(held, {contact_of({2, 1}, 0, 5)})[0].along_normal, 1);
}

TEST(HeldImpulses, OnlyWhatHoldsIsKept) {
  const Step step;
  EXPECT_EQ(hold_impulses(step.contacts, step.impulses).size(), 2400u);
  EXPECT_TRUE(hold_impulses({}, {}).empty());
}

}  // namespace
}  // namespace drape
