#include <gtest/gtest.h>

#include <algorithm>

#include "contact/active_contacts.h"
#include "contact/response.h"
#include "scene.h"

namespace drape {
namespace {

using test::one_triangle;
using test::Random;
using test::Scene;

constexpr double thickness = 0.01;

std::vector<Contact> active(const Scene& scene) {
  std::vector<Contact> contacts;
  Proximity proximity = scene.proximity();
  find_active_pairs(scene.phase(), proximity, contacts);
  return contacts;
}

// A triangle in the plane y = 0, and a smaller one over its middle whose lowest corner comes down on it.
Scene approaching(double from, double to, double friction = 0) {
  Scene scene;
  scene.add_cloth(one_triangle({-1, 0, -1}, {0, 0, 1}, {1, 0, -1}), thickness, friction);
  scene.add_cloth(one_triangle({0, from, 0}, {0.1, from + 1, 0}, {-0.1, from + 1, 0.1}), thickness, friction);
  for (int v = 3; v < 6; ++v) scene.end[v].y() += to - from;
  return scene;
}

TEST(ActiveContacts, SidesThatStayApartMakeNone) {
  EXPECT_TRUE(active(approaching(0.1, 0.02)).empty());
  EXPECT_TRUE(active(approaching(0.1, 0.5)).empty());
}

TEST(ActiveContacts, APairIsFoundOnTheSideThatItComesFromThoughItEndsBeyond) {
  for (const double to : {0.009, -0.3, -50.0}) {
    bool found = false;
    for (const Contact& contact : active(approaching(0.1, to)))
      if (contact.kind == 0 && contact.vertices[0] == 3) {
        EXPECT_LT((contact.normal - Vec3(0, 1, 0)).norm(), 1e-12);
        EXPECT_EQ(contact.target, thickness);
        found = true;
      }
    EXPECT_TRUE(found) << to;
  }
}

TEST(ActiveContacts, OldOverlapHealsSlowlyAndIsNoVelocity) {
  for (const double distance : {0.0002, 0.004, 0.0099}) {
    const std::vector<Contact> contacts = active(approaching(distance, distance));
    ASSERT_FALSE(contacts.empty());
    EXPECT_NEAR(contacts[0].target, distance, 1e-15);
    EXPECT_GE(contacts[0].push_target, distance);
    EXPECT_LE(contacts[0].push_target, distance + 0.1 * thickness);
  }
}

TEST(ActiveContacts, OverlapHealsToNineTenthsOfTheThicknessAndNoFurther) {
  EXPECT_GT(active(approaching(0.0085, 0.0085)).at(0).push_target, 0.0086);
  EXPECT_NEAR(active(approaching(0.0089999, 0.0089999)).at(0).push_target, 0.9 * thickness, 1e-15);
  EXPECT_NEAR(active(approaching(0.0095, 0.0095)).at(0).push_target, 0.0095, 1e-15);
}

TEST(ActiveContacts, OverlapWhosePushesArePausedHealsToATwentiethOfTheThickness) {
  EXPECT_GT(active(approaching(0.0003, 0.0003)).at(0).paused_push_target, 0.0004);
  EXPECT_NEAR(active(approaching(0.0004999, 0.0004999)).at(0).paused_push_target, 0.05 * thickness, 1e-15);
  EXPECT_NEAR(active(approaching(0.0085, 0.0085)).at(0).paused_push_target, 0.0085, 1e-15);
}

// A twentieth of its thickness would be less than what the fail-safe keeps.
TEST(ActiveContacts, OverlapOfThinClothWhosePushesArePausedHealsToTwiceTheGapOfTheFailSafe) {
  constexpr double thin = 10 * test::least_gap;
  Scene scene;
  scene.add_cloth(one_triangle({-1, 0, -1}, {0, 0, 1}, {1, 0, -1}), thin);
  scene.add_cloth(one_triangle({-1, 1.9 * test::least_gap, -1}, {0, 1.9 * test::least_gap, 1},
                               {1, 1.9 * test::least_gap, -1}),
                  thin);
  EXPECT_NEAR(active(scene).at(0).paused_push_target, 2 * test::least_gap, 1e-15);
}

TEST(ActiveContacts, WeightsAreBarycentricAndTheirSumIsZero) {
  Random random(1);
  Scene scene;
  scene.add_cloth(make_grid({0.5, 0.5}, {7, 7}), thickness);
  for (std::size_t v = 0; v < scene.start.size(); ++v) {
    scene.start[v] += random.vector(0.05);
    scene.end[v] = scene.start[v] + random.vector(0.1);
  }
  const std::vector<Contact> contacts = active(scene);
  EXPECT_GT(contacts.size(), 20u);
  for (const Contact& contact : contacts) {
    double sum = 0, size = 0;
    for (const double weight : contact.weights) {
      sum += weight;
      size += std::abs(weight);
    }
    EXPECT_NEAR(sum, 0, 1e-12);
    EXPECT_NEAR(size, 2, 1e-12);
    EXPECT_NEAR(contact.normal.norm(), 1, 1e-12);
    // Edges that are closest at an end are left to points and triangles.
    for (const double weight : contact.weights) EXPECT_TRUE(contact.kind == 0 || weight != 0);
  }
}

// A cloth whose points all go their own ways, slowly beside what they have in common.
struct Drifting {
  Scene scene;
  std::vector<Vec3> velocity;

  explicit Drifting(unsigned seed) {
    Random random(seed);
    scene.add_cloth(make_grid({0.5, 0.5}, {12, 12}), thickness);
    for (Vec3& x : scene.start) x += random.vector(0.04);
    scene.end = scene.start;
    for (std::size_t v = 0; v < scene.start.size(); ++v)
      velocity.push_back(Vec3(0, -0.1, 0) + random.vector(0.003));
  }
  void aim() {
    for (std::size_t v = 0; v < velocity.size(); ++v) scene.end[v] = scene.start[v] + velocity[v];
  }
};

std::vector<Contact> find(const Scene& scene, Proximity& proximity) {
  update_proximity(scene.geometry, scene.motion(), {0.01, 0.05, 0.1}, proximity);
  std::vector<Contact> contacts;
  find_active_pairs(scene.phase(), proximity, contacts);
  return contacts;
}

void expect_same(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].kind, b[i].kind);
    EXPECT_EQ(a[i].place, b[i].place);
    EXPECT_EQ(a[i].vertices, b[i].vertices);
    EXPECT_EQ(a[i].weights, b[i].weights);
    EXPECT_EQ(a[i].normal, b[i].normal);
    EXPECT_EQ(a[i].target, b[i].target);
  }
}

// Pairs are passed over by what they are known to keep apart; that must cost none.
TEST(ActiveContacts, ListsThatAreKeptFindTheSameBitsInTheSameOrderAsNewOnes) {
  Drifting drifting(2);
  Proximity kept = start_proximity(drifting.scene.geometry);
  std::size_t found = 0;
  for (int step = 0; step < 40; ++step) {
    drifting.aim();
    Proximity fresh = start_proximity(drifting.scene.geometry);
    const std::vector<Contact> with_kept = find(drifting.scene, kept);
    expect_same(with_kept, find(drifting.scene, fresh));
    found += with_kept.size();
    follow_motion(drifting.scene.motion(), kept);
    drifting.scene.start = drifting.scene.end;
  }
  EXPECT_GT(found, 1000u);
}

// A sphere under a triangle, which turns about `axis` by `angle` and moves by `way`.
Scene on_sphere(double friction, const Vec3& axis, double angle, const Vec3& way) {
  const double radius = 0.5;
  Scene scene;
  const double height = radius + thickness;
  scene.add_cloth(one_triangle({-1, height, -1}, {0, height, 1}, {1, height, -1}), thickness, friction);
  scene.geometry.inverse_masses = {1, 1, 1};
  const int sphere = scene.add_sphere({0, 0, 0}, radius, friction);
  scene.move_body(sphere, {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), way});
  for (int v = 0; v < 3; ++v) scene.end[v].y() -= 0.01;
  return scene;
}

Vec3 contact_point(const std::vector<Vec3>& x, const Contact& contact) {
  Vec3 point = Vec3::Zero();
  for (int i = 1; i < 4; ++i) point -= contact.weights[i] * x[contact.vertices[i]];
  return point;
}

TEST(TurningSphere, ItsContactCarriesTheMotionOfTheSurface) {
  const Scene scene = on_sphere(1, {0, 0, 1}, 0.02, {0, 0, 0});
  const std::vector<Contact> contacts = active(scene);
  ASSERT_EQ(contacts.size(), 1u);
  const Vec3 top(0, 0.5, 0);
  EXPECT_LT((contacts[0].turn - (scene.bodies[1].end(top) - top)).norm(), 1e-12);
}

TEST(TurningSphere, ARoughOneTakesTheClothAlongAndASmoothOneDoesNot) {
  for (const double friction : {0.0, 100.0}) {
    Scene scene = on_sphere(friction, {0, 0, 1}, 0.02, {0, 0, 0});
    const std::vector<Contact> contacts = active(scene);
    ASSERT_EQ(contacts.size(), 1u);
    test::resolve(scene, test::exact(contacts));
    const Vec3 way = contact_point(scene.end, contacts[0]) - contact_point(scene.start, contacts[0]);
    EXPECT_NEAR(way.x(), friction > 0 ? -0.5 * std::sin(0.02) : 0, 1e-6);
  }
}

TEST(TurningSphere, OneThatRollsUnderTheClothLeavesItWhereItIs) {
  const double angle = 0.002;  // about z: the top goes to -x by as much as the centre goes to +x
  Scene scene = on_sphere(100, {0, 0, 1}, angle, {0.5 * std::sin(angle), 0, 0});
  const std::vector<Contact> contacts = active(scene);
  ASSERT_EQ(contacts.size(), 1u);
  test::resolve(scene, test::exact(contacts));
  const Vec3 way = contact_point(scene.end, contacts[0]) - contact_point(scene.start, contacts[0]);
  EXPECT_NEAR(way.x(), 0, 1e-5);
}

// A triangle that lies on the ball and tilts meanwhile: the place is where it touches then.
TEST(RoundedCollider, AStandingContactIsWhereTheStepLeads) {
  Scene scene = on_sphere(0, {0, 0, 1}, 0, {0, 0, 0});
  for (int v = 0; v < 3; ++v) scene.end[v].y() -= 0.2 * scene.start[v].x();
  const std::vector<Contact> contacts = active(scene);
  ASSERT_EQ(contacts.size(), 1u);
  const double tilt = std::atan(0.2);
  EXPECT_NEAR(std::abs(contacts[0].normal.x()), std::sin(tilt), 1e-3);
  EXPECT_GT(std::abs(contact_point(scene.start, contacts[0]).x()), 0.05);
}

TEST(TurningSphere, OneThatDoesNotTurnAddsNothing) {
  const std::vector<Contact> contacts = active(on_sphere(1, {0, 0, 1}, 0, {0.01, 0.01, 0}));
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_LT(contacts[0].turn.norm(), 1e-15);
}

TEST(TurningCapsule, ItsContactCarriesTheMotionOfTheSurface) {
  Scene scene;
  const double radius = 0.1, height = radius + thickness;
  scene.add_cloth(one_triangle({-0.3, height, -0.3}, {0, height, 0.3}, {0.3, height, -0.3}), thickness, 1);
  const int capsule = scene.add_capsule({0, 0, -2}, {0, 0, 2}, radius, 1);
  scene.move_body(capsule, {Eigen::AngleAxisd(0.03, Vec3(0, 0, 1)).toRotationMatrix(), Vec3::Zero()});
  for (int v = 0; v < 3; ++v) scene.end[v].y() -= 0.01;
  const std::vector<Contact> contacts = active(scene);
  ASSERT_FALSE(contacts.empty());
  const Vec3 top(0, radius, 0), way = scene.bodies[1].end(top) - top;
  for (const Contact& contact : contacts) {
    const double sign = scene.geometry.vertex_body[contact.vertices[0]] == capsule ? 1 : -1;
    EXPECT_LT((sign * contact.turn - way).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace drape
