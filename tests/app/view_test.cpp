#include "app/view.h"

#include <gtest/gtest.h>

namespace drape::app {
namespace {

TEST(Camera, StandsWhereItIsPut) {
  CameraDescription camera;
  camera.at = {1, 2, 3};
  EXPECT_EQ(camera_at(camera, {}, 50).eye, Vec3f(1, 2, 3));
}

TEST(Camera, GoesRoundFromZTowardsXAndComesBackAfterTheLastFrame) {
  CameraDescription camera;
  camera.look_at = {0, 1, 0};
  camera.orbit = CameraDescription::Orbit{2, 0.5, 0, 1};
  TimeSettings time;
  time.first_frame = 1;
  time.last_frame = 100;
  EXPECT_LT((camera_at(camera, time, 1).eye - Vec3f(0, 1.5f, 2)).norm(), 1e-6f);
  EXPECT_LT((camera_at(camera, time, 26).eye - Vec3f(2, 1.5f, 0)).norm(), 1e-6f);
  EXPECT_LT((camera_at(camera, time, 101).eye - camera_at(camera, time, 1).eye).norm(), 1e-6f);
}

SceneDescription scene_of_planes(int count) {
  SceneDescription scene;
  for (int i = 0; i < count; ++i) {
    ColliderDescription plane;
    plane.input.shape = PlaneShape{};
    scene.colliders.push_back(plane);
  }
  return scene;
}

TEST(Ground, IsTheHighestLevelPlaneThatIsVisible) {
  SceneDescription scene = scene_of_planes(4);
  CachedFrame frame;
  frame.collider_poses.resize(4);
  frame.collider_poses[0].translation.y() = -1;
  frame.collider_poses[1].translation.y() = 0.5;
  frame.collider_poses[2].translation.y() = 2;
  scene.colliders[2].visible = false;
  frame.collider_poses[3].translation.y() = 3;
  frame.collider_poses[3].rotation = rotation_from_degrees({20, 0, 0});
  const render::View view = frame_view(scene, frame);
  EXPECT_TRUE(view.ground.visible);
  EXPECT_EQ(view.ground.height, 0.5f);
}

TEST(Ground, IsNotDrawnWhereThereIsNone) {
  CachedFrame frame;
  EXPECT_FALSE(frame_view(SceneDescription{}, frame).ground.visible);
}

TEST(PictureSettings, QualityIsTheNumberOfPasses) {
  RenderDescription render;
  render.quality = Quality::draft;
  EXPECT_EQ(picture_settings(render).passes, 2);
  render.quality = Quality::final;
  EXPECT_EQ(picture_settings(render).passes, 32);
}

}  // namespace
}  // namespace drape::app
