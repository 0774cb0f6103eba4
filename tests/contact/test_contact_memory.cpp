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
struct Step {
  std::vector<Contact> contacts;
  std::vector<ContactMemory> memories;

  Step() {
    for (int i = 0; i < 3000; ++i) {
      contacts.push_back(contact_of({i / 30, i / 10 % 3}, i % 10 < 5 ? 0 : 1, i));
      memories.push_back({i % 5 == 0 ? 0.0 : i, Vec3(0, i, 1), i % 10 == 0 ? 3 : 0});
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

TEST(ContactMemory, ComesBackToItsContactWhicheverHaveComeAndGone) {
  const Step step;
  const std::vector<RememberedContact> remembered =
      remember(all_but_each(7, step.contacts), all_but_each(7, step.memories));
  const std::vector<Contact> now = all_but_each(11, step.contacts);
  const std::vector<ContactMemory> recalled = recall(remembered, now);
  ASSERT_EQ(recalled.size(), now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    const int number = now[i].vertices[0];
    const bool was_held = number % 7 != 0 && number % 5 != 0, is_paused = number % 7 != 0 && number % 10 == 0;
    EXPECT_EQ(recalled[i].impulse, was_held ? number : 0) << number;
    EXPECT_EQ(recalled[i].friction_impulse, was_held || is_paused ? Vec3(0, number, 1) : Vec3(0, 0, 0));
    EXPECT_EQ(recalled[i].paused_steps, is_paused ? 3 : 0);
  }
}

TEST(ContactMemory, IsNotThatOfTheSameVerticesAndAnotherKind) {
  const std::vector<RememberedContact> remembered =
      remember({contact_of({2, 1}, 0, 5)}, {{1, Vec3::Zero(), 0}});
  EXPECT_EQ(recall(remembered, {contact_of({2, 1}, 1, 5)})[0].impulse, 0);
  EXPECT_EQ(recall(remembered, {contact_of({2, 1}, 0, 5)})[0].impulse, 1);
}

TEST(ContactMemory, IsOfContactsThatAreHeldOrNotToBePushed) {
  const Step step;
  EXPECT_EQ(remember(step.contacts, step.memories).size(), 2700u);
  EXPECT_TRUE(remember({}, {}).empty());
}

}  // namespace
}  // namespace drape
