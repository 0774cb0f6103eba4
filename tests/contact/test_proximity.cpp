#include <gtest/gtest.h>

#include <set>

#include "contact/proximity.h"
#include "core/parallel.h"
#include "scene.h"

namespace drape {
namespace {

using test::Random;
using test::Scene;
using Key = std::pair<PairKind, std::array<int, 4>>;

constexpr double pad = 0.02, cell_size = 0.3;

bool update(const Scene& scene, ProximityList& list) {
  return update_proximity(scene.geometry, scene.motion(), pad, cell_size, list);
}

bool covers(const Scene& scene, const ProximityList& list) {
  return within_boxes(scene.geometry, list, scene.motion());
}

void follow(const Scene& scene, ProximityList& list) { follow_motion(scene.geometry, scene.motion(), list); }

Key key(PairKind kind, std::array<int, 4> v) {
  if (kind == PairKind::edge_edge && v[0] > v[2]) v = {v[2], v[3], v[0], v[1]};
  return {kind, v};
}

std::multiset<Key> keys(const ProximityList& list) {
  std::multiset<Key> all;
  for (const ContactPair& pair : list.pairs) all.insert(key(pair.kind, pair.vertices));
  return all;
}

bool is_for(const Scene& scene, const ProximityList& list, const test::AnyPair& pair) {
  const auto [a, b] = pair_bodies(scene.geometry, pair.kind, pair.vertices);
  return list.own_body < 0 ? a != b : a == list.own_body && b == list.own_body;
}

// How many pairs come within their thickness in the step; each is to be in the list.
int expect_all_near_pairs(const Scene& scene, const ProximityList& list) {
  const std::multiset<Key> listed = keys(list);
  int near = 0;
  for (const test::AnyPair& pair : test::all_pairs(scene.geometry)) {
    if (!is_for(scene, list, pair)) continue;
    const FourPoints start = gather(scene.start, pair.vertices), end = gather(scene.end, pair.vertices);
    const double thickness = pair_thickness(scene.geometry, pair.kind, pair.vertices);
    if (test::least_distance(pair.kind, start, end, 10) > thickness) continue;
    EXPECT_EQ(listed.count(key(pair.kind, pair.vertices)), 1u);
    ++near;
  }
  return near;
}

TriangleMesh small_cloth() { return make_grid({0.6, 0.6}, {7, 7}); }

// A cloth crumpled into a small room, over a second one and round a box and a sphere.
Scene crumpled(unsigned seed, double way) {
  Random random(seed);
  Scene scene;
  scene.add_cloth(small_cloth(), 0.02);
  scene.add_cloth(test::shifted(make_grid({0.6, 0.6}, {5, 5}), {0, 0.1, 0}), 0.03);
  scene.add_mesh(make_box({0.2, 0.2, 0.2}));
  scene.add_sphere({0.3, 0, 0}, 0.1);
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

TEST(Proximity, AllPairsThatComeNearInAStepAreListed) {
  int near = 0;
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const double way : {0.005, 0.05, 0.4}) {
      const Scene scene = crumpled(seed, way);
      for (const ProximityList& list : scene.lists(0, cell_size)) near += expect_all_near_pairs(scene, list);
    }
  EXPECT_GT(near, 1000);
}

TEST(Proximity, AKeptListHoldsAllPairsThatComeNearLaterToo) {
  Random random(5);
  Scene scene = crumpled(5, 0.006);
  std::vector<ProximityList> lists = scene.lists(pad, cell_size);
  int kept = 0;
  for (int step = 0; step < 30; ++step)
    for (ProximityList& list : lists) {
      kept += !update(scene, list);
      expect_all_near_pairs(scene, list);
      follow(scene, list);
      if (&list == &lists.back()) go_on(scene, random, 0.001);
    }
  EXPECT_GT(kept, 30);
}

TEST(Proximity, NoPairIsListedTwiceOrSharesAVertex) {
  const Scene scene = crumpled(6, 0.1);
  for (const ProximityList& list : scene.lists()) {
    const std::multiset<Key> all = keys(list);
    EXPECT_EQ(std::set<Key>(all.begin(), all.end()).size(), all.size());
    for (const auto& [kind, v] : all) EXPECT_EQ(std::set<int>(v.begin(), v.end()).size(), 4u);
  }
}

TEST(Proximity, PairsOfOnlyPinnedVerticesAndCollidersAreLeftOut) {
  Scene scene = crumpled(7, 0.05);
  for (int v = 0; v < 49; ++v) scene.geometry.inverse_masses[v] = 0;
  for (const ProximityList& list : scene.lists()) {
    if (list.own_body == 0) {
      EXPECT_TRUE(list.pairs.empty());
    }
    for (const ContactPair& pair : list.pairs)
      EXPECT_TRUE(std::any_of(pair.vertices.begin(), pair.vertices.end(),
                              [&](int v) { return scene.geometry.inverse_masses[v] > 0; }));
  }
}

TEST(Proximity, PairsCarryTheirThicknessAndFriction) {
  Scene scene = crumpled(8, 0.05);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    scene.geometry.bodies[b].friction = 0.1 * static_cast<double>(b + 1);
  for (const ProximityList& list : scene.lists())
    for (const ContactPair& pair : list.pairs) {
      const auto [a, b] = pair_bodies(scene.geometry, pair.kind, pair.vertices);
      EXPECT_EQ(pair.thickness, pair_thickness(scene.geometry, pair.kind, pair.vertices));
      EXPECT_EQ(pair.friction, pair_friction(scene.geometry, a, b));
      EXPECT_FALSE(pair.counts_edge_ends && scene.geometry.bodies[a].is_cloth &&
                   scene.geometry.bodies[b].is_cloth);
    }
}

TEST(Proximity, EdgeEndsCountForACapsuleWhichHasNoTriangles) {
  Scene scene;
  scene.add_cloth(small_cloth(), 0.02);
  scene.add_capsule({-1, 0.05, 0}, {1, 0.05, 0}, 0.05);
  int edge_pairs = 0;
  const ProximityList list = scene.lists()[0];
  for (const ContactPair& pair : list.pairs)
    if (pair.kind == PairKind::edge_edge) {
      EXPECT_TRUE(pair.counts_edge_ends);
      ++edge_pairs;
    }
  EXPECT_GT(edge_pairs, 5);
}

TEST(Proximity, AListIsKeptWhileVerticesStayInTheirBoxes) {
  Random random(9);
  Scene scene = crumpled(9, 0.001);
  ProximityList list;
  EXPECT_FALSE(covers(scene, list));
  EXPECT_TRUE(update(scene, list));
  const std::multiset<Key> built = keys(list);
  for (int step = 0; step < 5; ++step) {
    EXPECT_TRUE(covers(scene, list));
    EXPECT_FALSE(update(scene, list));
    follow(scene, list);
    go_on(scene, random, 0);
  }
  EXPECT_EQ(keys(list), built);
}

TEST(Proximity, AListIsBuiltAnewWhereOneVertexLeavesItsBox) {
  Scene scene = crumpled(10, 0);
  ProximityList list = scene.lists(pad, cell_size)[0];
  scene.end[3] += Vec3(0, 0, 0.9 * pad);
  EXPECT_FALSE(update(scene, list));
  scene.end[3] += Vec3(0, 0, 0.2 * pad);
  EXPECT_FALSE(covers(scene, list));
  EXPECT_TRUE(update(scene, list));
  EXPECT_TRUE(covers(scene, list));
}

// The fail-safe may hold back a vertex while the others move on.
TEST(Proximity, AListIsBuiltAnewWhereAVertexThatStaysBehindWouldLeaveItsBox) {
  Scene scene;
  scene.add_cloth(small_cloth(), 0.02);
  ProximityList list = scene.lists(pad, cell_size)[1];
  for (Vec3& x : scene.end) x.y() -= 0.9 * pad;
  EXPECT_FALSE(update(scene, list));
  for (Vec3& x : scene.end) x.y() -= 0.2 * pad;
  EXPECT_TRUE(update(scene, list));
}

TEST(Proximity, TheWholeOfAFastStepIsInTheBoxes) {
  const Scene scene = crumpled(11, 0.4);
  for (const ProximityList& list : scene.lists(pad, cell_size)) {
    if (list.own_body >= 0) continue;
    for (std::size_t v = 0; v < scene.start.size(); ++v)
      for (const Vec3& x : {scene.start[v], scene.end[v]}) {
        EXPECT_TRUE((x.array() >= list.lower[v].array() + 0.99 * pad).all());
        EXPECT_TRUE((x.array() <= list.upper[v].array() - 0.99 * pad).all());
      }
  }
}

TEST(Proximity, VerticesWaysAreCountedLessWhatTheClothMovedAsAWhole) {
  Scene scene;
  scene.add_cloth(small_cloth(), 0.02);
  ProximityList list = scene.lists()[1];
  for (Vec3& x : scene.end) x += Vec3(0, -0.5, 0);
  scene.end[0] += Vec3(0.03, 0, 0);
  scene.end[1] -= Vec3(0.03, 0, 0);
  follow(scene, list);
  follow(scene, list);
  EXPECT_NEAR(list.travelled[0], 0.06, 1e-12);
  EXPECT_NEAR(list.travelled[1], 0.06, 1e-12);
  EXPECT_NEAR(list.travelled[2], 0, 1e-12);
}

// What all vertices have in common brings no pair nearer.
TEST(Proximity, AFallingClothKeepsItsOwnListAndTheWorldsIsBuiltAnew) {
  Scene scene;
  scene.add_cloth(small_cloth(), 0.02);
  std::vector<ProximityList> lists = scene.lists(pad, cell_size);
  int world_builds = 0;
  for (int step = 0; step < 60; ++step) {
    for (std::size_t v = 0; v < scene.start.size(); ++v)
      scene.end[v] = scene.start[v] + Vec3(0, -0.0003 * step, 0);  // up to nearly the pad in a step
    EXPECT_FALSE(update(scene, lists[1])) << "step " << step;
    world_builds += update(scene, lists[0]);
    for (ProximityList& list : lists) follow(scene, list);
    scene.start = scene.end;
  }
  EXPECT_GT(world_builds, 5);
}

TEST(Proximity, TheFrameMovesAsTheMeanOfAClothAndNotBetweenBodies) {
  Scene scene;
  scene.add_cloth(small_cloth(), 0.02);
  scene.end[0] += Vec3(0, 49, 0);
  ProximityList list;
  EXPECT_EQ(frame_motion(scene.geometry, list, scene.motion()), Vec3(0, 0, 0));
  list.own_body = 0;
  EXPECT_NEAR((frame_motion(scene.geometry, list, scene.motion()) - Vec3(0, 1, 0)).norm(), 0, 1e-14);
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
    const ProximityList list = scene.lists()[1];
    for (const ContactPair& pair : list.pairs) results.back().push_back(pair.vertices);
  }
  EXPECT_GT(results[0].size(), 1000u);
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

}  // namespace
}  // namespace drape
