#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/fixed_scenes.h"
#include "render/rasterizer.h"

namespace drape::render::test {
namespace {

constexpr Settings settings{240, 160, 16};

View view_of_ground() {
  View view;
  view.camera.eye = {0, 5, 3};
  view.camera.target = {0, 0, 0};
  view.ground.visible = true;
  return view;
}

float brightness_at(const Image& image, const Vec3f& point, const View& view) {
  const Vec2f place = seen_at(point, view, settings);
  return pixel(image, static_cast<int>(place.x()), static_cast<int>(place.y())).mean();
}

// A ball in the air, the sun alone and a point: on the ground stands an ellipse, 2 r across the light's
// direction and 2 r / sin(height of the sun) along it.
TEST(Shadow, FallsWhereTheGeometrySays) {
  View view = view_of_ground();
  view.sun.direction = {0.8f, -1, 0};
  view.sun.size = 0;
  view.sky.intensity = 0;
  const float radius = 0.25f;
  const Vec3f ball(-0.7f, 1, 0);
  const Image image = Rasterizer().draw({make_ball(ball, radius)}, view, settings);
  const Vec3f center(0.1f, 0, 0);
  const float along = radius / (view.sun.direction.normalized() * -1).y();
  for (const float share : {0.0f, 0.5f, 0.85f}) {
    EXPECT_LT(brightness_at(image, center + share * Vec3f(along, 0, 0), view), 8);
    EXPECT_LT(brightness_at(image, center - share * Vec3f(0, 0, radius), view), 8);
  }
  for (const float share : {1.15f, 1.5f}) {
    EXPECT_GT(brightness_at(image, center + share * Vec3f(along, 0, 0), view), 100);
    EXPECT_GT(brightness_at(image, center - share * Vec3f(0, 0, radius), view), 100);
  }
}

TEST(Shadow, ALargerSunMakesASofterEdge) {
  View view = view_of_ground();
  view.sun.direction = {0, -1, 0};
  view.sky.intensity = 0;
  const std::vector<Surface> ball = {make_ball({-0.2f, 1.2f, 0}, 0.3f)};
  const Vec3f just_inside(0.03f, 0, 0);
  view.sun.size = 0;
  EXPECT_LT(brightness_at(Rasterizer().draw(ball, view, settings), just_inside, view), 8);
  view.sun.size = 12;
  EXPECT_GT(brightness_at(Rasterizer().draw(ball, view, settings), just_inside, view), 40);
}

TEST(Shadow, TheSkyDarkensWhereThingsTouch) {
  View view = view_of_ground();
  view.sun.intensity = 0;
  const Image image = Rasterizer().draw({make_ball({0, 0.3f, 0}, 0.3f)}, view, settings);
  const float far_away = brightness_at(image, {1.5f, 0, 1}, view);
  const float beside = brightness_at(image, {0.33f, 0, 0.05f}, view);
  const float at_the_foot = brightness_at(image, {0.19f, 0, 0.14f}, view);
  EXPECT_LT(beside, far_away - 8);
  EXPECT_LT(at_the_foot, beside - 8);
}

// A flat wall in slanting light must not shade itself in streaks (acne).
TEST(Shadow, AFlatSurfaceDoesNotShadeItself) {
  for (const float slant : {0.2f, 1.0f, 4.0f}) {
    View view = view_from_z(4);
    light_head_on(view);
    view.sun.direction = {slant, -0.3f * slant, -1};
    const Image image = Rasterizer().draw({make_wall()}, view, {120, 120, 4});
    const Vec3f middle = pixel(image, 60, 60);
    for (int x = 36; x < 84; ++x) EXPECT_LT((pixel(image, x, 50) - middle).cwiseAbs().maxCoeff(), 4) << slant;
  }
}

TEST(Shadow, NothingOfTheFixedScenesIsBlack) {
  Rasterizer rasterizer;
  for (const FixedScene& scene : fixed_scenes()) {
    const Image image = rasterizer.draw(scene.surfaces, scene.view, settings);
    float darkest = 255;
    for (int y = 0; y < settings.height; ++y) {
      for (int x = 0; x < settings.width; ++x) darkest = std::min(darkest, pixel(image, x, y).maxCoeff());
    }
    EXPECT_GT(darkest, 25) << scene.name;
  }
}

// Between the ground and the backdrop there is no line.
TEST(Ground, DissolvesIntoTheBackdrop) {
  View view;
  view.ground.visible = true;
  view.camera.eye = {2.5f, 0.8f, 2.5f};
  const Image image = Rasterizer().draw({}, view, settings);
  for (int y = 1; y < settings.height; ++y) {
    const Vec3f step = pixel(image, 120, y) - pixel(image, 120, y - 1);
    EXPECT_LE(step.cwiseAbs().maxCoeff(), 4) << y;
  }
  EXPECT_LT((pixel(image, 120, 0) - 255 * view.backdrop).cwiseAbs().maxCoeff(), 1);
}

TEST(Ground, IsNotSeenFromBelow) {
  View view;
  view.ground.visible = true;
  view.camera.eye = {2, -1, 2};
  view.backdrop = {0, 0, 1};
  const Image image = Rasterizer().draw({}, view, settings);
  EXPECT_EQ(pixel(image, 120, 80), Vec3f(0, 0, 255));
}

}  // namespace
}  // namespace drape::render::test
