#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "contact/active_contacts.h"
#include "contact/response.h"
#include "core/parallel.h"
#include "scene.h"

namespace drape {
namespace {

using test::Scene;

constexpr double thickness = 0.01;

// A small cloth that lies at `height` over the plane y = 0.
Scene over_plane(double height, double friction = 0) {
  Scene scene;
  scene.add_cloth(test::shifted(make_grid({0.2, 0.2}, {3, 3}), {0.5, height, 0}), thickness, friction);
  scene.add_plane(friction);
  return scene;
}

std::vector<Contact> plane_contacts(const Scene& scene) {
  std::vector<Contact> contacts;
  find_plane_contacts(scene.phase(), contacts);
  return contacts;
}

void resolve(Scene& scene) { test::resolve(scene, plane_contacts(scene)); }

TEST(PlaneContact, VerticesAtOrUnderTheirThicknessAtTheEndAreInContact) {
  Scene scene = over_plane(0.02);
  EXPECT_TRUE(plane_contacts(scene).empty());
  scene.end[4].y() = 0.009;
  scene.end[7].y() = -5;
  const std::vector<Contact> contacts = plane_contacts(scene);
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_EQ(contacts[0].vertices[0], 4);
  EXPECT_EQ(contacts[1].vertices[0], 7);
  EXPECT_EQ(contacts[0].normal, Vec3(0, 1, 0));
}

TEST(PlaneContact, ContactsOfManyVerticesWithTwoPlanesAreInOrderWithAnyNumberOfThreads) {
  Scene scene;
  scene.add_cloth(test::shifted(make_grid({1, 1}, {60, 60}), {0, 0.011, 0}), thickness);
  scene.add_plane();
  scene.add_plane();
  std::vector<std::array<int, 2>> places;
  for (const Contact& contact : plane_contacts(scene)) places.push_back(contact.place);
  EXPECT_EQ(places.size(), 7200u);
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end()));
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    std::vector<std::array<int, 2>> again;
    for (const Contact& contact : plane_contacts(scene)) again.push_back(contact.place);
    EXPECT_EQ(again, places) << threads << " threads";
  }
}

TEST(PlaneContact, AFallingVertexEndsAtItsThickness) {
  Scene scene = over_plane(0.02);
  for (int v = 0; v < 9; ++v) scene.end[v].y() = -1;
  resolve(scene);
  for (int v = 0; v < 9; ++v) EXPECT_NEAR(scene.end[v].y(), thickness, 1e-15);
}

TEST(PlaneContact, OldOverlapIsNoMoreThanKeptFromGrowing) {
  Scene scene = over_plane(0.004);
  for (int v = 0; v < 9; ++v) scene.end[v].y() = 0;
  const std::vector<Contact> contacts = plane_contacts(scene);
  ASSERT_EQ(contacts.size(), 9u);
  EXPECT_NEAR(contacts[0].target, 0.004, 1e-15);
  EXPECT_GT(contacts[0].push_target, 0.004);
  EXPECT_LT(contacts[0].push_target, thickness);
  resolve(scene);
  EXPECT_NEAR(scene.end[0].y(), 0.004, 1e-15);
}

TEST(PlaneContact, PinnedVerticesMakeNone) {
  Scene scene = over_plane(0.02);
  scene.geometry.inverse_masses[4] = 0;
  scene.end[4].y() = -1;
  EXPECT_TRUE(plane_contacts(scene).empty());
}

TEST(PlaneContact, ATiltedPlaneHoldsAlongItsOwnNormal) {
  Scene scene = over_plane(1);
  const RigidPose pose{Eigen::AngleAxisd(0.5, Vec3(0, 0, 1)).toRotationMatrix(), Vec3(0, 0.1, 0)};
  scene.bodies[1] = {pose, pose};
  scene.end[4] = Vec3(0.5, -2, 0);
  resolve(scene);
  EXPECT_NEAR(pose.rotation.col(1).dot(scene.end[4] - pose.translation), thickness, 1e-15);
  EXPECT_LT(pose.rotation.col(1).cross(scene.end[4] - Vec3(0.5, -2, 0)).norm(), 1e-14);
}

TEST(PlaneContact, ARisingPlaneLiftsTheCloth) {
  Scene scene = over_plane(0.01);
  scene.bodies[1].end.translation.y() = 0.3;
  resolve(scene);
  for (int v = 0; v < 9; ++v) EXPECT_NEAR(scene.end[v].y(), 0.31, 1e-14);
}

TEST(PlaneContact, ARoughPlaneThatSlidesCarriesTheClothAndASmoothOneDoesNot) {
  for (const double friction : {0.0, 100.0}) {
    Scene scene = over_plane(0.01, friction);
    scene.bodies[1].end.translation.x() = 0.02;
    for (int v = 0; v < 9; ++v) scene.end[v].y() -= 0.005;
    resolve(scene);
    for (int v = 0; v < 9; ++v)
      EXPECT_NEAR(scene.end[v].x() - scene.start[v].x(), friction > 0 ? 0.02 : 0, 1e-12);
  }
}

TEST(PlaneContact, ARoughPlaneThatTurnsTakesTheClothRound) {
  Scene scene = over_plane(0.01, 100);
  const RigidPose turned{Eigen::AngleAxisd(0.1, Vec3(0, 1, 0)).toRotationMatrix(), Vec3::Zero()};
  scene.bodies[1].end = turned;
  for (int v = 0; v < 9; ++v) scene.end[v].y() -= 0.005;
  resolve(scene);
  for (int v = 0; v < 9; ++v) EXPECT_LT((scene.end[v] - turned(scene.start[v])).norm(), 1e-12);
}

TEST(PlaneContact, SlidingOverAPlaneIsBrakedByFrictionTimesTheFall) {
  const double friction = 0.3, fall = 0.002;
  Scene scene = over_plane(0.01, friction);
  for (int v = 0; v < 9; ++v) scene.end[v] += Vec3(0.01, -fall, 0);
  resolve(scene);
  for (int v = 0; v < 9; ++v)
    EXPECT_NEAR(scene.end[v].x() - scene.start[v].x(), 0.01 - friction * fall, 1e-14);
}

}  // namespace
}  // namespace drape
