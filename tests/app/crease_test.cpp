#include "app/crease.h"

#include <gtest/gtest.h>

#include "app/collider_surface.h"
#include "mesh/primitives.h"

namespace drape::app {
namespace {

TEST(Crease, ABoxKeepsItsEdges) {
  const render::Surface box = surface_with_creases(make_box({1, 2, 3}), 40);
  EXPECT_EQ(box.positions.size(), 24u);  // each corner once for each of its three sides
  EXPECT_EQ(box.triangles.size(), 12u);
  for (const Vec3f& normal : box.normals) EXPECT_FLOAT_EQ(normal.cwiseAbs().maxCoeff(), 1);
}

TEST(Crease, ASphereIsSmooth) {
  const TriangleMesh sphere = make_sphere(2, 48, 24);
  const render::Surface surface = surface_with_creases(sphere, 40);
  EXPECT_EQ(surface.positions.size(), sphere.positions.size());
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    EXPECT_GT(surface.normals[i].dot(surface.positions[i].normalized()), 0.99f);
  }
}

TEST(Crease, SeamsSplitPointsThatHaveTwoTextureCoordinates) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {2, 1, 3}};
  EXPECT_EQ(split_at_seams(triangles, {}).point_of.size(), 4u);
  const DrawnVertices vertices = split_at_seams(triangles, {{0, 1, 2}, {4, 1, 3}});
  EXPECT_EQ(vertices.point_of, std::vector<int>({0, 1, 2, 2, 3}));
  EXPECT_EQ(vertices.uv_of, std::vector<int>({0, 1, 2, 4, 3}));
  EXPECT_EQ(vertices.triangles[1], (Triangle{3, 1, 4}));
}

TEST(ColliderSurface, FollowsItsPose) {
  ColliderDescription ball;
  ball.input.shape = SphereShape{1};
  RigidPose pose;
  pose.translation = {5, 0, 0};
  const render::Surface surface = posed(collider_surface(ball), pose);
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    EXPECT_NEAR((surface.positions[i] - Vec3f(5, 0, 0)).norm(), 1, 1e-5);
  }
  EXPECT_FALSE(surface.two_sided);
}

}  // namespace
}  // namespace drape::app
