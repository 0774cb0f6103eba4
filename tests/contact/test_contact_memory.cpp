#include "contact/contact_memory.h"

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

// Contacts of many pairs of patches, in order. Each has an impulse of its own, but for every fifth; of these
// every other is not to be pushed.
std::vector<Contact> many_contacts() {
  std::vector<Contact> contacts;
  for (int i = 0; i < 3000; ++i) {
    contacts.push_back(contact_of({i / 30, i / 10 % 3}, i % 10 < 5 ? 0 : 1, i));
    contacts.back().memory = {i % 5 == 0 ? 0.0 : i, Vec3(0, i, 1), i % 10 == 0 ? 3 : 0};
  }
  return contacts;
}

std::vector<Contact> all_but_each(int nth, const std::vector<Contact>& contacts) {
  std::vector<Contact> some;
  for (const Contact& contact : contacts)
    if (contact.vertices[0] % nth != 0) some.push_back(contact);
  return some;
}

TEST(ContactMemory, ComesBackToItsContactWhicheverHaveComeAndGone) {
  const std::vector<RememberedContact> remembered = remember(all_but_each(7, many_contacts()));
  std::vector<Contact> now = all_but_each(11, many_contacts());
  for (Contact& contact : now) contact.memory = {5, {5, 5, 5}, 5};
  recall(remembered, now);
  for (const Contact& contact : now) {
    const int number = contact.vertices[0];
    const bool was_held = number % 7 != 0 && number % 5 != 0, is_paused = number % 7 != 0 && number % 10 == 0;
    EXPECT_EQ(contact.memory.impulse, was_held ? number : 0) << number;
    EXPECT_EQ(contact.memory.friction_impulse, was_held || is_paused ? Vec3(0, number, 1) : Vec3(0, 0, 0));
    EXPECT_EQ(contact.memory.steps_to_push, is_paused ? 3 : 0);
  }
}

TEST(ContactMemory, IsNotThatOfTheSameVerticesAndAnotherKind) {
  Contact contact = contact_of({2, 1}, 0, 5);
  contact.memory = {1, Vec3::Zero(), 0};
  std::vector<Contact> now = {contact_of({2, 1}, 1, 5), contact_of({2, 1}, 0, 5)};
  recall(remember({contact}), now);
  EXPECT_EQ(now[0].memory.impulse, 0);
  EXPECT_EQ(now[1].memory.impulse, 1);
}

TEST(ContactMemory, IsOfContactsThatAreHeldOrNotToBePushed) {
  EXPECT_EQ(remember(many_contacts()).size(), 2700u);
  EXPECT_TRUE(remember({}).empty());
}

}  // namespace
}  // namespace drape
