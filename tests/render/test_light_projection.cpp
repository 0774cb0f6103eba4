#include <gtest/gtest.h>

#include <cmath>

#include "render/light_projection.h"

namespace drape::render {
namespace {

const Sphere casters{{1, 2, 3}, 0.7f};
constexpr int map_size = 1024;

std::vector<Vec3f> directions() {
  return {Vec3f(0, 1, 0), Vec3f(0, -1, 0), Vec3f(1, 0, 0), Vec3f(0.6f, 0.64f, -0.48f)};
}

TEST(LightProjection, PutsTheSphereInTheMiddleOfTheMap) {
  for (const Vec3f& to_light : directions()) {
    const LightProjection light = fit_light(to_light, casters, map_size);
    const Vec4f center = light.map_from_world * casters.center.homogeneous();
    EXPECT_NEAR(center.x(), 512, 0.01);
    EXPECT_NEAR(center.y(), 512, 0.01);
    EXPECT_NEAR(center.z(), 0.5, 1e-4);
  }
}

TEST(LightProjection, FillsTheMapButForANarrowBorder) {
  for (const Vec3f& to_light : directions()) {
    const LightProjection light = fit_light(to_light, casters, map_size);
    const Vec3f sideways = to_light.unitOrthogonal();
    const Vec4f rim = light.map_from_world * (casters.center + casters.radius * sideways).homogeneous();
    EXPECT_NEAR((rim.head<2>() - Vec2f(512, 512)).norm(), 503, 0.01);
    EXPECT_NEAR(light.texel_size, casters.radius / 503, 1e-6);
  }
}

TEST(LightProjection, DepthGrowsAwayFromTheLight) {
  for (const Vec3f& to_light : directions()) {
    const LightProjection light = fit_light(to_light, casters, map_size);
    const Vec4f nearer = light.map_from_world * (casters.center + casters.radius * to_light).homogeneous();
    const Vec4f farther = light.map_from_world * (casters.center - casters.radius * to_light).homogeneous();
    EXPECT_GE(nearer.z(), 0);
    EXPECT_LT(nearer.z(), 0.02f);
    EXPECT_LE(farther.z(), 1);
    EXPECT_GT(farther.z(), 0.98f);
  }
}

TEST(DirectionToSun, SpansTheSunsAngle) {
  Sun sun;
  sun.size = 10;
  const Vec3f middle = direction_to_sun(sun, {0, 0});
  EXPECT_LT((middle + sun.direction.normalized()).norm(), 1e-6f);
  for (const Vec2f& rim : {Vec2f(1, 0), Vec2f(0, -1), Vec2f(0.6f, 0.8f)}) {
    const float degrees = std::acos(middle.dot(direction_to_sun(sun, rim))) * 57.29578f;
    EXPECT_NEAR(degrees, 5, 0.01);
  }
}

TEST(BoundingSphere, HoldsAllPointsOfAllSurfaces) {
  std::vector<Surface> surfaces(2);
  surfaces[0].positions = {{0, 0, 0}, {2, 0, 0}};
  surfaces[1].positions = {{1, 1, 0}, {1, -1, 0}};
  const Sphere sphere = bounding_sphere(surfaces);
  EXPECT_LT((sphere.center - Vec3f(1, 0, 0)).norm(), 1e-6f);
  EXPECT_NEAR(sphere.radius, 1, 1e-6);
  EXPECT_EQ(bounding_sphere({}).radius, 0);
}

}  // namespace
}  // namespace drape::render
