#include "contact/contact_step.h"

#include <gtest/gtest.h>

#include "scene.h"

namespace drape {
namespace {

using test::one_triangle;
using test::Scene;

constexpr double thickness = 0.01, step = 0.001;

ContactStepResult advance(Scene& scene, const ContactSettings& settings,
                          std::vector<RememberedContact>& remembered) {
  ContactScratch scratch = start_contacts(scene.geometry);
  Profile profile;
  return step_contacts(scene.geometry, settings, scene.bodies, scene.start, scratch, remembered, profile,
                       scene.end);
}

ContactStepResult advance(Scene& scene, std::vector<RememberedContact>& remembered) {
  return advance(scene, contact_settings(scene.geometry, step), remembered);
}

ContactStepResult advance(Scene& scene, const ContactSettings& settings) {
  std::vector<RememberedContact> nothing;
  return advance(scene, settings, nothing);
}

ContactStepResult advance(Scene& scene) { return advance(scene, contact_settings(scene.geometry, step)); }

Scene layers(const std::vector<double>& heights) {
  Scene scene;
  for (const double y : heights) scene.add_cloth(one_triangle({-1, y, -1}, {0, y, 1}, {1, y, -1}), thickness);
  return scene;
}

void lower(Scene& scene, int cloth, double way) {
  const auto [begin, end] = scene.vertices(cloth);
  for (int v = begin; v < end; ++v) scene.end[v].y() -= way;
}

TEST(ContactStep, WithoutContactTheWayIsKeptToTheBit) {
  Scene scene = layers({0, 0.05});
  lower(scene, 1, 0.0301234567891234);
  const std::vector<Vec3> end = scene.end;
  const ContactStepResult result = advance(scene);
  EXPECT_EQ(result.contacts, 0);
  EXPECT_EQ(scene.end, end);
}

// The upper layer drives the middle one down on a third, which it had no contact with.
TEST(ContactStep, ContactsThatTheResponseMakesAreResolvedInTheSameStep) {
  Scene scene = layers({0, 0.03, 0.05});
  lower(scene, 2, 0.1);
  const ContactStepResult result = advance(scene);
  EXPECT_EQ(result.limited_vertices, 0);
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(scene.end[i].y(), -0.005);
    EXPECT_GT(scene.end[3 + i].y() - scene.end[i].y(), 0.5 * thickness);
    EXPECT_GT(scene.end[6 + i].y() - scene.end[3 + i].y(), 0.5 * thickness);
  }
}

TEST(ContactStep, WhatOthersPushOnAPlaneKeepsItsThicknessOverIt) {
  Scene scene = layers({0.012, 0.03});
  scene.add_plane();
  lower(scene, 1, 0.02);
  advance(scene);
  for (int i = 0; i < 3; ++i) EXPECT_GT(scene.end[i].y(), 0.98 * thickness);
}

// The upper layer drives the middle one down, one of whose corners meets what stays and was not near it: only
// the second search finds that. Its edges let the other corners not go on alone.
TEST(ContactStep, WhatIsResolvedAnewKeepsItsEdgesWithinTheirLimits) {
  constexpr double side = 0.05;
  const TriangleMesh mesh = one_triangle({0, 0, 0}, {side, 0, 0}, {0, 0, side});
  Scene scene;
  scene.add_cloth(test::shifted(mesh, {-0.6 * side, 0, -0.3 * side}), thickness);
  scene.add_cloth(test::shifted(mesh, {0, 0.03, 0}), thickness);
  scene.add_cloth(test::shifted(mesh, {0, 0.045, 0}), thickness);
  for (int v = 0; v < 3; ++v) scene.geometry.inverse_masses[v] = 0;
  lower(scene, 2, 0.1);
  ContactSettings settings = contact_settings(scene.geometry, step);
  settings.edge_limits = make_edge_limits(
      {{{3, 4}, 0.95 * side, 1.05 * side}, {{3, 5}, 0.95 * side, 1.05 * side}}, {0, 1, 2}, 9);
  EXPECT_EQ(advance(scene, settings).limited_vertices, 0);
  EXPECT_LT((scene.end[4] - scene.end[3]).norm(), 1.06 * side);
  EXPECT_LT((scene.end[5] - scene.end[3]).norm(), 1.06 * side);
}

// Eight layers on a plane, which weigh on each other: sweeps alone end before the lowest carries all.
TEST(ContactStep, WhatHeldAStackInTheLastStepHoldsItInTheNext) {
  Scene scene = layers({0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08});
  scene.add_plane();
  for (int cloth = 0; cloth < 8; ++cloth) lower(scene, cloth, 5e-5);
  const std::vector<Vec3> wanted = scene.end;
  std::vector<RememberedContact> remembered;
  const auto sag = [&] {
    scene.end = wanted;
    advance(scene, remembered);
    double farthest = 0;
    for (std::size_t v = 0; v < scene.end.size(); ++v)
      farthest = std::max(farthest, scene.start[v].y() - scene.end[v].y());
    return farthest;
  };
  const double first = sag();
  EXPECT_FALSE(remembered.empty());
  for (int again = 0; again < 10; ++again) sag();
  EXPECT_LT(sag(), 0.8 * first);
}

std::vector<double> heights_after(int steps, Scene& scene, std::vector<RememberedContact>& remembered) {
  for (int i = 0; i < steps; ++i) {
    scene.start = scene.end;
    advance(scene, remembered);
  }
  std::vector<double> heights;
  for (std::size_t v = 0; v < scene.end.size(); v += 3) heights.push_back(scene.end[v].y());
  return heights;
}

TEST(ContactStep, LayersThatHaveRoomArePushedNearlyTheirThicknessApart) {
  Scene scene = layers({0, 0.003});
  std::vector<RememberedContact> remembered;
  const std::vector<double> heights = heights_after(60, scene, remembered);
  EXPECT_NEAR(heights[1] - heights[0], 0.9 * thickness, 1e-4);
}

// One between two that stay, where both would push it. After some vain pushes it is left alone for a quarter
// of a second.
TEST(ContactStep, ALayerThatHasNoRoomIsLeftAlone) {
  Scene scene = layers({0, 0.006, 0.013});
  for (int v = 0; v < 9; ++v)
    if (v < 3 || v >= 6) scene.geometry.inverse_masses[v] = 0;
  std::vector<RememberedContact> remembered;
  const std::vector<double> settled = heights_after(5, scene, remembered);
  EXPECT_NE(settled[1], 0.006);
  EXPECT_EQ(heights_after(240, scene, remembered), settled);
  EXPECT_NE(heights_after(10, scene, remembered), settled);
}

// An edge that stands on a plane and is too short: what the plane takes back of its pull is pulled again.
TEST(ContactStep, LimitsHearOfWhatCollidersTookBack) {
  Scene scene;
  scene.add_cloth(one_triangle({0, thickness, 0}, {0, 0.1, 0}, {5, 0.1, 0}), thickness);
  scene.add_plane();
  ContactSettings settings = contact_settings(scene.geometry, step);
  settings.edge_limits = make_edge_limits({{{0, 1}, 0.13, 1}}, {0, 1}, 3);
  const double lack = 0.13 - (0.1 - thickness);
  advance(scene, settings);
  EXPECT_NEAR(scene.end[0].y(), thickness, 1e-12);
  EXPECT_NEAR(scene.end[1].y(), 0.1 + (0.5 + 0.25) * lack, 1e-12)
      << "half of what lacks, and of what lacks still";
}

TEST(ContactStep, WhereNothingCanGiveWayTheFailSafeHoldsIt) {
  Scene scene = layers({0, 0.03});
  for (double& inverse_mass : scene.geometry.inverse_masses) inverse_mass = 0;
  lower(scene, 1, 0.1);
  EXPECT_GT(advance(scene).limited_vertices, 0);
  for (int i = 0; i < 3; ++i) EXPECT_GT(scene.end[3 + i].y(), scene.end[i].y());
}

// It lies deeper than its thickness and is lifted a little, which takes nothing from the friction.
TEST(ContactStep, FrictionIsThatOfTheFallWhereOldOverlapHeals) {
  constexpr double friction = 0.5, fall = 1e-4, slide = 1e-3;
  Scene scene;
  scene.add_cloth(test::shifted(make_grid({0.2, 0.2}, {3, 3}), {0, 0.3 * thickness, 0}), thickness, friction);
  scene.add_plane(friction);
  for (Vec3& p : scene.end) p += Vec3(slide, -fall, 0);
  advance(scene);
  for (std::size_t v = 0; v < scene.end.size(); ++v) {
    EXPECT_GT(scene.end[v].y(), scene.start[v].y() + 1e-6);
    EXPECT_NEAR(scene.end[v].x() - scene.start[v].x(), slide - friction * fall, 1e-6);
  }
}

}  // namespace
}  // namespace drape
