#include <gtest/gtest.h>

#include <map>
#include <set>

#include "contact/proximity.h"
#include "core/parallel.h"
#include "scene.h"

namespace drape {
namespace {

using test::Random;
using test::Scene;
using Key = std::pair<PairKind, std::array<int, 4>>;

constexpr ProximityMargins margins{0.01, 0.03, 0.05};

int update(const Scene& scene, Proximity& proximity) {
  return update_proximity(scene.geometry, scene.motion(), margins, proximity);
}

struct Listed {
  const PatchPair* patches;
  ContactPair pair;
  double expiry, least_distance;
};

std::multimap<Key, Listed> listed_pairs(const Proximity& proximity) {
  std::multimap<Key, Listed> all;
  for (const PatchPair& patches : proximity.pairs)
    for (std::size_t i = 0; i < patches.pairs.size(); ++i)
      all.insert({{contact_pair(patches, i).kind, patches.pairs[i].vertices},
                  {&patches, contact_pair(patches, i), patches.pairs[i].expiry, least_distance(patches, i)}});
  return all;
}

// Pairs that come within `distance` (less a hair) must be in a list, and the clock must say so. `stopped`:
// the clock of vertices that may stop on their ways. Returns how many there are.
int expect_listed(const Scene& scene, const Proximity& proximity, const std::vector<Vec3>& end,
                  bool stopped) {
  const std::multimap<Key, Listed> listed = listed_pairs(proximity);
  int near = 0;
  for (const auto& [kind, vertices] : test::all_pairs(scene.geometry)) {
    const auto [a, b] = pair_bodies(scene.geometry, kind, vertices);
    const double thickness = pair_thickness(scene.geometry, kind, vertices);
    const double reach = pair_radius(scene.geometry, a, b) + (stopped ? 1e-5 : thickness);
    if (test::least_distance(kind, gather(scene.start, vertices), gather(end, vertices), 10) > reach)
      continue;
    ++near;
    const auto [first, last] = listed.equal_range({kind, vertices});
    EXPECT_EQ(std::distance(first, last), 1);
    if (first == last) continue;
    const auto& [patches, pair, expiry, least] = first->second;
    EXPECT_LE(least, closest_points(kind, gather(scene.start, vertices)).distance);
    if (stopped)
      EXPECT_GE(patches->travelled + relative_way_if_stopped(proximity, *patches) + 2e-5,
                expiry + pair.thickness);
    else
      EXPECT_GE(patches->travelled + relative_way(proximity, *patches), expiry);
  }
  return near;
}

TriangleMesh small_cloth() { return make_grid({0.6, 0.6}, {7, 7}); }

// A cloth crumpled into a small room, over a second one and round a box, a ball and a capsule.
Scene crumpled(unsigned seed, double way) {
  Random random(seed);
  Scene scene;
  scene.add_cloth(small_cloth(), 0.02);
  scene.add_cloth(test::shifted(make_grid({0.6, 0.6}, {5, 5}), {0, 0.1, 0}), 0.03);
  scene.add_mesh(make_box({0.2, 0.2, 0.2}));
  scene.add_sphere({0.3, 0, 0}, 0.1);
  scene.add_capsule({-0.3, 0, -0.1}, {-0.3, 0, 0.1}, 0.05);
  for (std::size_t v = 0; v < scene.start.size(); ++v) {
    if (scene.geometry.inverse_masses[v] > 0) scene.start[v] += random.vector(0.12);
    scene.end[v] = scene.start[v] + random.vector(way);
  }
  return scene;
}

// Moves on: everything takes about the same way again.
void go_on(Scene& scene, Random& random, double change) {
  for (std::size_t v = 0; v < scene.start.size(); ++v) {
    const Vec3 way = scene.end[v] - scene.start[v];
    scene.start[v] = scene.end[v];
    scene.end[v] += way + random.vector(change);
  }
}

std::vector<Vec3> stopped_anywhere(const Scene& scene, Random& random) {
  std::vector<Vec3> end;
  for (std::size_t v = 0; v < scene.start.size(); ++v)
    end.push_back(scene.start[v] + random.between(0, 1) * (scene.end[v] - scene.start[v]));
  return end;
}

std::vector<double> lifetimes(const Proximity& proximity) {
  std::vector<double> all;
  for (const PatchPair& patches : proximity.pairs) all.push_back(patches.valid_until);
  return all;
}

TEST(Proximity, AllPairsThatComeNearInAStepAreListed) {
  int near = 0;
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const double way : {0.005, 0.05, 0.4}) {
      const Scene scene = crumpled(seed, way);
      near += expect_listed(scene, scene.proximity(), scene.end, false);
    }
  EXPECT_GT(near, 1000);
}

TEST(Proximity, KeptListsHoldAllPairsThatComeNearLaterToo) {
  for (const double way : {0.0005, 0.003}) {
    Random random(5);
    Scene scene = crumpled(5, way);
    Proximity proximity = start_proximity(scene.geometry);
    int near = 0, made = 0, could_be_made = 0;
    for (int step = 0; step < 40; ++step) {
      made += update(scene, proximity);
      could_be_made += static_cast<int>(proximity.pairs.size());
      near += expect_listed(scene, proximity, scene.end, false);
      follow_motion(scene.motion(), proximity);
      go_on(scene, random, 0.1 * way);
    }
    EXPECT_GT(near, 1000);
    EXPECT_LT(made, could_be_made / 2);
  }
}

// As the fail-safe may have it: each vertex goes only a share of its way.
TEST(Proximity, ListsHoldAllPairsThatTouchWhereverVerticesStop) {
  Random random(6);
  int near = 0;
  Scene scene = crumpled(6, 0.01);
  Proximity proximity = start_proximity(scene.geometry);
  for (int step = 0; step < 40; ++step) {
    for (Vec3& x : scene.end) x += Vec3(0.1, 0, 0);  // that they have this in common counts no longer
    update(scene, proximity);
    const std::vector<Vec3> end = stopped_anywhere(scene, random);
    near += expect_listed(scene, proximity, end, true);
    follow_motion({scene.start, end}, proximity);
    scene.end = end;
    go_on(scene, random, 0.002);
  }
  EXPECT_GT(near, 200);
}

TEST(Proximity, NoPairIsListedTwiceOrSharesAVertex) {
  const Scene scene = crumpled(7, 0.1);
  const Proximity proximity = scene.proximity();
  std::set<Key> keys;
  for (const auto& [key, listed] : listed_pairs(proximity)) {
    EXPECT_TRUE(keys.insert(key).second);
    EXPECT_EQ(std::set<int>(key.second.begin(), key.second.end()).size(), 4u);
  }
  EXPECT_GT(keys.size(), 1000u);
}

// The fail-safe holds pins back from colliders, so it must know of their pairs; colliders may meet each
// other.
TEST(Proximity, PairsOfPinnedVerticesAreListedAndThoseOfCollidersAreNot) {
  Scene scene = crumpled(8, 0.05);
  const std::size_t free = listed_pairs(scene.proximity()).size();
  for (int v = 0; v < 49; ++v) scene.geometry.inverse_masses[v] = 0;
  const auto pinned = listed_pairs(scene.proximity());
  EXPECT_EQ(pinned.size(), free);
  for (const auto& [key, listed] : pinned) {
    const auto [a, b] = pair_bodies(scene.geometry, key.first, key.second);
    EXPECT_TRUE(scene.geometry.bodies[a].is_cloth || scene.geometry.bodies[b].is_cloth);
  }
}

TEST(Proximity, WithoutSelfCollisionOnlyPairsBetweenBodiesAreListed) {
  Scene scene = crumpled(9, 0.05);
  scene.geometry.self_collision = false;
  const Proximity proximity = scene.proximity();
  const auto listed = listed_pairs(proximity);
  EXPECT_GT(listed.size(), 300u);
  for (const auto& [key, where] : listed) {
    const auto [a, b] = pair_bodies(scene.geometry, key.first, key.second);
    EXPECT_NE(a, b);
  }
}

TEST(Proximity, PairsCarryTheirThicknessAndFriction) {
  Scene scene = crumpled(10, 0.05);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    scene.geometry.bodies[b].friction = 0.1 * static_cast<double>(b + 1);
  const Proximity proximity = scene.proximity();
  for (const auto& [key, listed] : listed_pairs(proximity)) {
    const ContactPair& pair = listed.pair;
    const auto [a, b] = pair_bodies(scene.geometry, pair.kind, pair.vertices);
    EXPECT_EQ(pair.thickness, pair_thickness(scene.geometry, pair.kind, pair.vertices));
    EXPECT_EQ(pair.radius, pair_radius(scene.geometry, a, b));
    EXPECT_EQ(pair.friction, pair_friction(scene.geometry, a, b));
    EXPECT_EQ(pair.meets_collider, !scene.geometry.bodies[a].is_cloth || !scene.geometry.bodies[b].is_cloth);
    EXPECT_FALSE(pair.counts_edge_ends && scene.geometry.bodies[a].is_cloth &&
                 scene.geometry.bodies[b].is_cloth);
  }
}

TEST(Proximity, EdgeEndsCountForACapsuleWhichHasNoTriangles) {
  Scene scene;
  scene.add_cloth(small_cloth(), 0.02);
  scene.add_capsule({-1, 0.05, 0}, {1, 0.05, 0}, 0.05);
  int edge_pairs = 0;
  const Proximity proximity = scene.proximity();
  for (const auto& [key, listed] : listed_pairs(proximity))
    if (pair_bodies(scene.geometry, key.first, key.second)[1] == 1 && key.first == PairKind::edge_edge) {
      EXPECT_TRUE(listed.pair.counts_edge_ends);
      ++edge_pairs;
    }
  EXPECT_GT(edge_pairs, 5);
}

TEST(Proximity, WhatDoesNotMoveKeepsItsLists) {
  const Scene scene = crumpled(11, 0);
  Proximity proximity = start_proximity(scene.geometry);
  const int made = update(scene, proximity);
  EXPECT_EQ(made, static_cast<int>(proximity.pairs.size()));
  EXPECT_GT(made, 5);
  for (int step = 0; step < 5; ++step) {
    follow_motion(scene.motion(), proximity);
    EXPECT_EQ(update(scene, proximity), 0);
  }
}

TEST(Proximity, OnlyListsOfAPatchThatMovesAreMadeAnew) {
  Scene scene;
  scene.add_cloth(make_grid({2, 2}, {30, 30}), 0.01);
  scene.add_cloth(test::shifted(make_grid({2, 2}, {30, 30}), {0, 0.1, 0}), 0.01);
  Proximity proximity = start_proximity(scene.geometry);
  update(scene, proximity);
  const std::vector<double> before = lifetimes(proximity);
  scene.end[450] += Vec3(0, 0.025, 0);
  const int made = update(scene, proximity);
  EXPECT_GT(made, 5);
  EXPECT_LT(made, static_cast<int>(before.size()) / 10);
  for (std::size_t p = 0; p < proximity.pairs.size(); ++p) {
    const PatchPair& patches = proximity.pairs[p];
    const auto has = [&](int patch) {
      const std::vector<int>& vertices = proximity.patches[patch].vertices;
      return std::find(vertices.begin(), vertices.end(), 450) != vertices.end();
    };
    if (has(patches.first) || has(patches.second)) continue;
    EXPECT_EQ(patches.valid_until, before[p]);
  }
}

// What all vertices have in common brings no pair nearer; but it brings them nearer to others.
TEST(Proximity, AFallingClothKeepsItsOwnListsThoughItLeavesItsRooms) {
  Scene scene;
  scene.add_cloth(make_grid({2, 2}, {30, 30}), 0.01);
  Proximity proximity = start_proximity(scene.geometry);
  const auto fall = [&](double way) {
    for (std::size_t v = 0; v < scene.start.size(); ++v) scene.end[v] = scene.start[v] - Vec3(0, way, 0);
    const int made = update(scene, proximity);
    follow_motion(scene.motion(), proximity);
    scene.start = scene.end;
    return made;
  };
  EXPECT_GT(fall(0.01), 0);
  int room_changes = 0;
  for (int step = 0; step < 100; ++step) {
    const Bounds moved = proximity.moved[0];
    EXPECT_EQ(fall(0.01), 0) << "step " << step;
    room_changes += proximity.moved[0].lower.y() > moved.lower.y();
  }
  EXPECT_GT(room_changes, 2);
}

TEST(Proximity, BodiesThatComeFromAfarAreFoundAsTheyMeet) {
  Scene scene;
  scene.add_cloth(small_cloth(), 0.02);
  scene.add_cloth(test::shifted(small_cloth(), {0.03, 2, 0.01}), 0.02);
  Proximity proximity = start_proximity(scene.geometry);
  int near = 0;
  for (int step = 0; step < 50; ++step) {
    for (int v = 49; v < 98; ++v) scene.end[v] = scene.start[v] - Vec3(0, 0.0399, 0);
    update(scene, proximity);
    if (step > 45) near += expect_listed(scene, proximity, scene.end, false);
    follow_motion(scene.motion(), proximity);
    scene.start = scene.end;
  }
  EXPECT_GT(near, 50);
}

TEST(Proximity, ListsAreTheSameWithAnyNumberOfThreads) {
  Scene scene;
  scene.add_cloth(make_grid({1, 1}, {30, 30}), 0.02);
  Random random(13);
  for (Vec3& x : scene.start) x += random.vector(0.05);
  scene.end = scene.start;
  std::vector<std::vector<std::array<int, 4>>> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    results.emplace_back();
    const Proximity proximity = scene.proximity();
    for (const PatchPair& patches : proximity.pairs)
      for (const ListedPair& pair : patches.pairs) results.back().push_back(pair.vertices);
  }
  EXPECT_GT(results[0].size(), 1000u);
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

}  // namespace
}  // namespace drape
