#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "contact/active_contacts.h"
#include "scene.h"

namespace drape {
namespace {

using test::one_triangle;
using test::Random;
using test::Scene;

constexpr double thickness = 0.03;
constexpr int probe = 0;  // vertex

// A surface, and a triangle that stands on its corner over it: at `place`, to go by `way`.
Scene probed(const TriangleMesh& surface, const Vec3& place, const Vec3& way = Vec3::Zero()) {
  Scene scene;
  scene.add_cloth(one_triangle(place, place + Vec3(0.01, 1, 0), place + Vec3(-0.01, 1, 0.01)), thickness);
  scene.add_mesh(surface);
  for (int v = 0; v < 3; ++v) scene.end[v] += way;
  return scene;
}

std::vector<Contact> contacts_of(const Scene& scene, int point) {
  std::vector<Contact> contacts;
  Proximity proximity = scene.proximity();
  find_active_pairs(scene.phase(), proximity, contacts);
  std::erase_if(contacts, [&](const Contact& c) {
    return static_cast<PairKind>(c.kind) != PairKind::point_triangle || c.vertices[0] != point;
  });
  return contacts;
}

std::vector<Contact> contacts_of_probe(const Scene& scene) { return contacts_of(scene, probe); }

TriangleMesh flat() { return make_grid({0.4, 0.4}, {9, 9}); }

TriangleMesh bumpy(Random& random) {
  TriangleMesh mesh = flat();
  for (Vec3& x : mesh.positions) x += Vec3(0, random.between(-0.03, 0.03), 0);
  return mesh;
}

// Two triangles that meet at the z axis and fall from there by `fall`.
TriangleMesh roof(double fall) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, -1}, {0, 0, 1}, {1, -fall, 0}, {-1, -fall, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  return mesh;
}

double gap(const Contact& contact, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 4; ++i) sum += contact.weights[i] * x[contact.vertices[i]];
  return contact.normal.dot(sum);
}

double least_gap_of(const std::vector<Contact>& contacts, const std::vector<Vec3>& x) {
  double least = 1e300;
  for (const Contact& contact : contacts) least = std::min(least, gap(contact, x));
  return least;
}

double distance_to(const TriangleMesh& mesh, const Vec3& point) {
  double least = 1e300;
  for (const auto& [a, b, c] : mesh.triangles)
    least = std::min(
        least,
        closest_point_triangle({point, mesh.positions[a], mesh.positions[b], mesh.positions[c]}).distance);
  return least;
}

// A random place over the middle of the flat grid, whose edges are 0.05 m long.
Vec3 over_the_middle(Random& random) {
  return {random.between(-0.1, 0.1), random.between(0.5, 0.9) * thickness, random.between(-0.1, 0.1)};
}

TEST(SharedFeatures, WhatIsNearestIsNeverLeftOut) {
  Random random(1);
  int near = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const TriangleMesh surface = bumpy(random);
    const Vec3 place(random.between(-0.22, 0.22), random.between(-0.02, 0.06), random.between(-0.22, 0.22));
    const double distance = distance_to(surface, place);
    if (distance > thickness || distance < 1e-6) continue;
    const Scene scene = probed(surface, place);
    EXPECT_NEAR(least_gap_of(contacts_of_probe(scene), scene.start), distance, 1e-12) << trial;
    ++near;
  }
  EXPECT_GT(near, 100);
}

// On average: where it is over a line between triangles, they have about the same, and both count.
TEST(SharedFeatures, APointOverAFlatSurfaceHasOneContact) {
  Random random(2);
  std::size_t all = 0;
  constexpr int trials = 300;
  for (int trial = 0; trial < trials; ++trial) {
    const std::size_t contacts = contacts_of_probe(probed(flat(), over_the_middle(random))).size();
    EXPECT_GE(contacts, 1u) << trial;
    EXPECT_LE(contacts, 6u) << trial;
    all += contacts;
  }
  EXPECT_LT(static_cast<double>(all), 1.2 * trials);
}

TEST(SharedFeatures, APointOverARidgeOrATipHasOneContact) {
  EXPECT_EQ(contacts_of_probe(probed(roof(0.5), {0, 0.02, 0.1})).size(), 1u);
  TriangleMesh pyramid;
  pyramid.positions = {{0, 0, 0}, {1, -1, 0}, {0, -1, 1}, {-1, -1, 0}, {0, -1, -1}};
  pyramid.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}};
  EXPECT_EQ(contacts_of_probe(probed(pyramid, {0.001, 0.02, 0.001})).size(), 1u);
}

TEST(SharedFeatures, APointInAValleyHasAContactWithEachSide) {
  EXPECT_EQ(contacts_of_probe(probed(roof(-0.5), {0.003, 0.02, 0.1})).size(), 2u);
}

// The point is over the one side only, but within a step it might go through the other.
TEST(SharedFeatures, APointBesideAValleyHasAContactWithTheSideThatBendsUpToo) {
  const Vec3 beside(0.012, 0.006 + 0.01, 0.1);
  EXPECT_EQ(contacts_of_probe(probed(roof(-0.5), beside)).size(), 2u);
  EXPECT_EQ(contacts_of_probe(probed(roof(0), {0.012, 0.01, 0.1})).size(), 1u) << "not where it is flat";
  EXPECT_EQ(contacts_of_probe(probed(roof(0.5), {0.012, -0.006 + 0.01, 0.1})).size(), 1u)
      << "nor over a ridge";
}

// Which way a triangle without area leads is only rounding: the two must not leave the point to each other.
TEST(SharedFeatures, ANeighbourThatHasCollapsedTakesNoContactAway) {
  Random random(6);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 a = random.vector(), b = a + random.vector(), c = a + random.vector();
    const Vec3 collapsed = a + random.between(0.1, 0.9) * (b - a);
    const Vec3 middle = 0.5 * (a + b), away = (a - b).cross(random.vector()).normalized();
    TriangleMesh mesh;
    mesh.positions = {a, b, c, collapsed};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
    if (trial % 2 == 1) std::swap(mesh.triangles[0], mesh.triangles[1]);
    EXPECT_FALSE(contacts_of_probe(probed(mesh, middle + 0.01 * away)).empty()) << trial;
  }
}

// What is near in the rest shape keeps less: the neighbour right under the point less than the one beside it.
TEST(SharedFeatures, AContactIsNotLeftToOneThatKeepsLess) {
  const Vec3 place(0.052, 0.02, 0.01), at_rest(0.052, 0.04, 0.01);
  ASSERT_EQ(contacts_of_probe(probed(flat(), place)).size(), 1u);
  TriangleMesh cloth = flat();
  const int point = static_cast<int>(cloth.positions.size());
  cloth.positions.insert(cloth.positions.end(), {at_rest, {0.06, 1, 0.01}, {0.05, 1, 0.02}});
  cloth.triangles.push_back({point, point + 1, point + 2});
  Scene folded;
  folded.add_cloth(cloth, thickness);
  folded.start[point] = folded.end[point] = place;
  EXPECT_GT(contacts_of(folded, point).size(), 1u);
}

TEST(SharedFeatures, AHandoverWithinAStepLeavesNoGapUnheld) {
  Random random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 way(random.between(-0.01, 0.01), -0.005, random.between(-0.01, 0.01));
    const Scene scene = probed(flat(), over_the_middle(random), way);
    double largest_lack = 0;
    for (const Contact& contact : contacts_of_probe(scene))
      largest_lack = std::max(largest_lack, contact.target - gap(contact, scene.end));
    EXPECT_GE(largest_lack, 0.005 - 1e-12) << trial << ": something must stop all of its way down";
  }
}

TEST(SharedFeatures, AFreeEdgeAndAFreeCornerHoldWhatIsNearestToThem) {
  EXPECT_EQ(contacts_of_probe(probed(flat(), {0.21, 0.01, 0.01})).size(), 1u);
  EXPECT_EQ(contacts_of_probe(probed(flat(), {0.21, 0.01, 0.21})).size(), 1u);
}

// Neighbours of the triangle under it must not resist: their contacts would lean against its way.
TEST(SharedFeatures, WhatGlidesOverAFlatSurfaceIsNotHeldBack) {
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 way(random.between(-0.002, 0.002), 0, random.between(-0.002, 0.002));
    const Scene scene = probed(flat(), over_the_middle(random), way);
    for (const Contact& contact : contacts_of_probe(scene))
      EXPECT_LT(contact.target - gap(contact, scene.end), 0.05 * way.norm() + 1e-12) << trial;
  }
}

// What held the point in the last step is asked first in this one, and is remembered by the pair.
TEST(SharedFeatures, OverACornerThereIsAContactThatRoundingDoesNotTakeAway) {
  Random random(4);
  std::set<std::array<int, 4>> always;
  for (int trial = 0; trial < 50; ++trial) {
    std::set<std::array<int, 4>> now, both;
    for (const Contact& contact :
         contacts_of_probe(probed(flat(), Vec3(0.05, 0.02, 0.05) + random.vector(1e-9))))
      now.insert(contact.vertices);
    std::set_intersection(always.begin(), always.end(), now.begin(), now.end(),
                          std::inserter(both, both.begin()));
    always = trial == 0 ? now : both;
  }
  EXPECT_FALSE(always.empty());
}

}  // namespace
}  // namespace drape
