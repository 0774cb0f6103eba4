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
  for (std::size_t g = 0; g < groups.group_count(); ++g) {
    const auto part_begin = [&](std::size_t group) {
      return static_cast<std::ptrdiff_t>(groups.part_begin[groups.round_begin[groups.group_begin[group]]]);
    };
    result.emplace_back(groups.order.begin() + part_begin(g), groups.order.begin() + part_begin(g + 1));
  }
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
  EXPECT_EQ(groups.group_count(), 0u);
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

std::set<int> moving_vertices_of_part(const Pile& pile, const CollisionGroups& groups, std::size_t part) {
  std::set<int> moving;
  for (std::size_t i = groups.part_begin[part]; i < groups.part_begin[part + 1]; ++i)
    moving.merge(pile.moving_vertices(groups.order[i]));
  return moving;
}

TEST(CollisionGroups, PartsOfARoundShareNoVertex) {
  const Pile pile;
  const CollisionGroups groups = groups_of(pile.scene, pile.contacts);
  ASSERT_EQ(groups.group_count(), 1u);
  ASSERT_EQ(groups.round_begin, (std::vector<std::size_t>{0, 8, 12, 15, 16}));
  for (std::size_t round = 0; round + 1 < groups.round_begin.size(); ++round) {
    std::set<int> seen;
    for (std::size_t part = groups.round_begin[round]; part < groups.round_begin[round + 1]; ++part)
      for (const int v : moving_vertices_of_part(pile, groups, part)) EXPECT_TRUE(seen.insert(v).second) << v;
  }
}

TEST(CollisionGroups, PartsOfALargeGroupAreAlikeAndItsJointsFew) {
  const Pile pile;
  const CollisionGroups groups = groups_of(pile.scene, pile.contacts);
  const auto size = [&](std::size_t part) {
    return static_cast<double>(groups.part_begin[part + 1] - groups.part_begin[part]);
  };
  for (std::size_t slab = 0; slab < 8; ++slab) EXPECT_NEAR(size(slab), 9899 / 8.0, 200);
  for (std::size_t joint = 8; joint < 15; ++joint) EXPECT_NEAR(size(joint), 100, 50);
  EXPECT_EQ(size(15), 0);
}

// It spans the pile, and so several slabs.
TEST(CollisionGroups, AContactOfManySlabsComesLastAndAlone) {
  Pile pile;
  pile.contacts.insert(pile.contacts.begin(), contact_of({4950, 51, 9951, 7050}));
  const CollisionGroups groups = groups_of(pile.scene, pile.contacts);
  EXPECT_EQ(groups.part_begin[16] - groups.part_begin[15], 1u);
  EXPECT_EQ(groups.order.back(), 0);
}

TEST(CollisionGroups, EachContactIsInOnePlace) {
  const Pile pile;
  const CollisionGroups groups = groups_of(pile.scene, pile.contacts);
  EXPECT_EQ(std::set(groups.order.begin(), groups.order.end()).size(), pile.contacts.size());
  EXPECT_EQ(groups.order.size(), pile.contacts.size());
  EXPECT_EQ(groups.part_begin.back(), pile.contacts.size());
}

}  // namespace
}  // namespace drape
