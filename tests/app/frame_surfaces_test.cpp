#include "app/frame_surfaces.h"

#include <gtest/gtest.h>

#include "mesh/primitives.h"

namespace drape::app {
namespace {

ClothDescription grid_cloth(int points, int subdivide) {
  ClothDescription cloth;
  cloth.input.mesh = make_grid({1, 1}, {points, points});
  cloth.look.subdivide = subdivide;
  return cloth;
}

CachedFrame at_rest(const SceneDescription& scene) {
  CachedFrame frame;
  for (const ClothDescription& cloth : scene.cloths) {
    for (const Vec3& position : cloth.input.mesh.positions) frame.positions.push_back(position.cast<float>());
  }
  frame.collider_poses.resize(scene.colliders.size());
  return frame;
}

TEST(FrameSurfaces, GivesEachClothItsOwnPoints) {
  SceneDescription scene;
  scene.cloths = {grid_cloth(3, 0), grid_cloth(4, 0)};
  CachedFrame frame = at_rest(scene);
  frame.positions[9] = {7, 8, 9};
  const auto surfaces = frame_surfaces(prepare_scene(scene), frame);
  ASSERT_EQ(surfaces.size(), 2u);
  EXPECT_EQ(surfaces[0].positions.size(), 9u);
  EXPECT_EQ(surfaces[1].positions.size(), 16u);
  EXPECT_EQ(surfaces[1].positions[0], Vec3f(7, 8, 9));
  EXPECT_EQ(surfaces[0].uvs.size(), 9u);
  EXPECT_TRUE(surfaces[0].two_sided);
}

TEST(FrameSurfaces, SubdividesWithTextureCoordinates) {
  SceneDescription scene;
  scene.cloths = {grid_cloth(3, 1)};
  const auto surfaces = frame_surfaces(prepare_scene(scene), at_rest(scene));
  EXPECT_EQ(surfaces[0].triangles.size(), 32u);
  EXPECT_EQ(surfaces[0].uvs.size(), surfaces[0].positions.size());
  for (const Vec3f& normal : surfaces[0].normals) EXPECT_GT(normal.y(), 0.999f);
}

// The rim of a table is an edge: neither end shades as if it were part of the side.
TEST(FrameSurfaces, DrawsTheEndsOfACylinderFlat) {
  SceneDescription scene;
  scene.colliders.resize(1);
  scene.colliders[0].input.shape = CylinderShape{0.09, 0.01};
  const auto surfaces = frame_surfaces(prepare_scene(scene), at_rest(scene));
  for (const Vec3f& normal : surfaces.at(0).normals)
    EXPECT_TRUE(std::abs(normal.y()) > 0.999f || std::abs(normal.y()) < 0.001f) << normal.transpose();
}

TEST(FrameSurfaces, LeavesOutLevelPlanesAndWhatIsInvisible) {
  SceneDescription scene;
  scene.colliders.resize(4);
  scene.colliders[0].input.shape = PlaneShape{};
  scene.colliders[1].input.shape = BoxShape{{1, 1, 1}};
  scene.colliders[2].input.shape = BoxShape{{1, 1, 1}};
  scene.colliders[2].visible = false;
  scene.colliders[3].input.shape = PlaneShape{};
  CachedFrame frame = at_rest(scene);
  frame.collider_poses[3].rotation = rotation_from_degrees({30, 0, 0});
  const auto surfaces = frame_surfaces(prepare_scene(scene), frame);
  ASSERT_EQ(surfaces.size(), 2u);
  EXPECT_EQ(surfaces[0].triangles.size(), 12u);
  EXPECT_EQ(surfaces[1].triangles.size(), 2u);
}

}  // namespace
}  // namespace drape::app
