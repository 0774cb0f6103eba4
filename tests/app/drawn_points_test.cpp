#include "app/drawn_points.h"

#include <gtest/gtest.h>

#include "app/frame_certificate.h"
#include "mesh/primitives.h"

namespace drape::app {
namespace {

SceneDescription cloth_over(ColliderShape shape) {
  SceneDescription scene;
  scene.cloths.resize(1);
  scene.cloths[0].input.mesh = make_grid({1, 1}, {5, 5});
  scene.cloths[0].look.subdivide = 2;
  scene.colliders.resize(1);
  scene.colliders[0].input.shape = shape;
  return scene;
}

// A ridge along the middle row, as high as `height`.
CachedFrame with_ridge(const SceneDescription& scene, float height) {
  CachedFrame frame;
  for (const Vec3& p : scene.cloths[0].input.mesh.positions) {
    frame.positions.push_back(p.cast<float>());
    if (std::abs(p.z()) < 0.01) frame.positions.back().y() += height;
  }
  frame.collider_poses.resize(1);
  return frame;
}

float highest(const std::vector<Vec3f>& points) {
  float highest = points.front().y();
  for (const Vec3f& p : points) highest = std::max(highest, p.y());
  return highest;
}

TEST(DrawnPoints, AreSmoothWhereNothingIsNear) {
  SceneDescription scene = cloth_over(SphereShape{0.1});
  CachedFrame frame = with_ridge(scene, 0.2f);
  frame.collider_poses[0].translation = Vec3(0, -5, 0);
  const PreparedScene prepared = prepare_scene(scene);
  EXPECT_EQ(drawn_points(prepared, frame)[0], prepared.cloths[0].subdivision->apply(frame.positions));
}

// Loop's surface cuts the ridge off, and would leave a beam under it sticking out.
TEST(DrawnPoints, StayOutOfAColliderThatTheSmoothSurfaceWouldEnter) {
  SceneDescription scene = cloth_over(BoxShape{Vec3(0.4, 0.075, 0.02)});
  CachedFrame frame = with_ridge(scene, 0.2f);
  frame.collider_poses[0].translation = Vec3(0, 0.14, 0);
  const CertifiedScene certified = prepare_certificate(scene);
  const std::vector<Vec3f> smooth = certified.drawn.cloths[0].subdivision->apply(frame.positions);
  ASSERT_FALSE(
      certify(as_one_surface(certified.drawn, {smooth}), certified.drawn.solids, frame.collider_poses)
          .in_colliders.empty());
  ASSERT_TRUE(is_certified(certify_frame(certified, frame)));
  const std::vector<Vec3f> drawn = drawn_points(certified.drawn, frame)[0];
  EXPECT_GT(highest(drawn), 0.18f);
  std::size_t smooth_points = 0;
  for (std::size_t v = 0; v < drawn.size(); ++v) smooth_points += drawn[v] == smooth[v];
  EXPECT_GT(smooth_points, drawn.size() / 3) << "what is far from the beam stays smooth";
}

// Two sheets 1 mm apart, one of them with a ridge that the other one follows from below.
TEST(DrawnPoints, OfTwoClothsDoNotMeet) {
  SceneDescription scene = cloth_over(SphereShape{0.1});
  scene.cloths.push_back(scene.cloths[0]);
  scene.cloths[0].look.subdivide = 0;
  CachedFrame frame = with_ridge(scene, 0.2f);
  frame.collider_poses[0].translation = Vec3(0, -5, 0);
  const std::vector<Vec3f> below = frame.positions;
  for (const Vec3f& p : below) frame.positions.push_back(p + Vec3f(0, 0.001f, 0));
  const CertifiedScene certified = prepare_certificate(scene);
  EXPECT_TRUE(is_certified(certify_frame(certified, frame)));
  const std::vector<Vec3f> smooth =
      certified.drawn.cloths[1].subdivision->apply({frame.positions.begin() + 25, frame.positions.end()});
  EXPECT_FALSE(certify(as_one_surface(certified.drawn, {below, smooth})).intersecting.empty());
}

}  // namespace
}  // namespace drape::app
