#include <gtest/gtest.h>

#include <set>

#include "contact/collision_groups.h"
#include "scene.h"

namespace drape {
namespace {

using test::Random;
using test::Scene;

Contact contact_of(const std::array<int, 4>& vertices,
                   const std::array<double, 4>& weights = {1, -0.3, -0.3, -0.4}) {
  Contact contact{};
  contact.vertices = vertices;
  contact.weights = weights;
  return contact;
}

// Free vertices.
Scene grid(std::array<int, 2> points) {
  Scene scene;
  scene.add_cloth(make_grid({1, 1}, points), 0.01);
  return scene;
}

CollisionGroups groups_of(const Scene& scene, const std::vector<Contact>& contacts) {
  return group_contacts(scene.geometry, scene.start, contacts);
}

// The contacts of each group.
std::vector<std::vector<int>> members(const CollisionGroups& groups) {
  std::vector<std::vector<int>> result;
  for (const CollisionGroup& group : groups.groups)
    result.emplace_back(groups.order.begin() + static_cast<std::ptrdiff_t>(group.joints_begin),
                        groups.order.begin() + static_cast<std::ptrdiff_t>(group.end));
  return result;
}

using Members = std::vector<std::vector<int>>;

TEST(CollisionGroups, DisjointContactsAreGroupsOfTheirOwn) {
  const auto groups = groups_of(
      grid({8, 5}), {contact_of({8, 9, 10, 11}), contact_of({0, 1, 2, 3}), contact_of({4, 5, 6, 7})});
  EXPECT_EQ(members(groups), (Members{{1}, {2}, {0}}));
}

TEST(CollisionGroups, ContactsThatShareVerticesThroughOthersAreOneGroupAndKeepTheirOrder) {
  const auto groups = groups_of(grid({8, 5}), {contact_of({9, 10, 11, 12}), contact_of({20, 21, 22, 23}),
                                               contact_of({0, 1, 2, 3}), contact_of({3, 4, 5, 9})});
  EXPECT_EQ(members(groups), (Members{{0, 2, 3}, {1}}));
}

TEST(CollisionGroups, VerticesThatDoNotMoveOrPlayNoPartJoinNothing) {
  Scene scene = grid({8, 5});
  scene.geometry.inverse_masses[3] = 0;
  const std::vector<Contact> pinned = {contact_of({0, 1, 2, 3}), contact_of({3, 4, 5, 6})};
  EXPECT_EQ(members(groups_of(scene, pinned)), (Members{{0}, {1}}));
  const std::vector<Contact> weightless = {contact_of({0, 1, 2, 3}, {1, -0.5, -0.5, 0}),
                                           contact_of({3, 4, 5, 6})};
  EXPECT_EQ(members(groups_of(grid({8, 5}), weightless)), (Members{{0}, {1}}));
}

TEST(CollisionGroups, NoContactsMakeNoGroup) {
  const CollisionGroups groups = groups_of(grid({8, 5}), {});
  EXPECT_TRUE(groups.order.empty());
  EXPECT_TRUE(groups.groups.empty());
}

// A large group, as the contacts of a pile: 10,000 of neighbours in a sheet.
struct Pile {
  Scene scene = grid({100, 100});
  std::vector<Contact> contacts;

  Pile() {
    for (int v = 0; v + 101 < 10000; ++v) contacts.push_back(contact_of({v, v + 1, v + 100, v + 101}));
    for (int v = 0; v < 100; ++v) scene.geometry.inverse_masses[100 * v] = 0;
  }

  std::set<int> moving_vertices(int contact) const {
    std::set<int> moving;
    for (const int v : contacts[contact].vertices)
      if (scene.geometry.inverse_masses[v] > 0) moving.insert(v);
    return moving;
  }
};

TEST(CollisionGroups, PartsOfALargeGroupShareNoVertexAndAreMostOfIt) {
  const Pile pile;
  const CollisionGroups groups = groups_of(pile.scene, pile.contacts);
  ASSERT_EQ(groups.groups.size(), 1u);
  const CollisionGroup& group = groups.groups[0];
  ASSERT_EQ(group.part_begin.size(), 9u);
  EXPECT_EQ(group.part_begin.back(), group.joints_begin);
  std::set<int> seen;
  for (std::size_t p = 0; p + 1 < group.part_begin.size(); ++p) {
    std::set<int> part;
    for (std::size_t i = group.part_begin[p]; i < group.part_begin[p + 1]; ++i)
      part.merge(pile.moving_vertices(groups.order[i]));
    for (const int v : part) EXPECT_TRUE(seen.insert(v).second) << v;
    EXPECT_NEAR(static_cast<double>(group.part_begin[p + 1] - group.part_begin[p]), 9899 / 8.0, 200);
  }
  EXPECT_LT(group.end - group.joints_begin, 1000u);
}

TEST(CollisionGroups, EachContactIsInOnePlace) {
  const Pile pile;
  const CollisionGroups groups = groups_of(pile.scene, pile.contacts);
  EXPECT_EQ(std::set(groups.order.begin(), groups.order.end()).size(), pile.contacts.size());
  EXPECT_EQ(groups.order.size(), pile.contacts.size());
  EXPECT_EQ(groups.groups[0].end, pile.contacts.size());
}

}  // namespace
}  // namespace drape
