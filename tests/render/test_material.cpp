#include <gtest/gtest.h>

#include "render/fixed_scenes.h"
#include "render/rasterizer.h"

namespace drape::render::test {
namespace {

constexpr Settings settings{96, 96, 8};

Image draw_wall(const Surface& wall, const View& view) { return Rasterizer().draw({wall}, view, settings); }

Vec3f middle(const Image& image) { return pixel(image, image.width / 2, image.height / 2); }

TEST(Material, EachSideHasItsColour) {
  Surface wall = make_wall();
  wall.material.color = {0.8f, 0.1f, 0.1f};
  wall.material.back = {0.1f, 0.1f, 0.8f};
  const Vec3f front = middle(draw_wall(wall, view_from_z(4)));
  const Vec3f back = middle(draw_wall(wall, view_from_z(-4)));
  EXPECT_GT(front.x(), 2 * front.z());
  EXPECT_GT(back.z(), 2 * back.x());
}

TEST(Material, WhatIsNotTwoSidedIsNotSeenFromBehind) {
  Surface wall = make_wall();
  wall.two_sided = false;
  View view = view_from_z(-4);
  view.backdrop = {0, 1, 0};
  EXPECT_EQ(middle(draw_wall(wall, view)), Vec3f(0, 255, 0));
}

TEST(Material, LightComesThroughCloth) {
  Surface wall = make_wall();
  View view = view_from_z(-4);
  light_head_on(view);
  wall.material.translucency = 0;
  const float opaque = middle(draw_wall(wall, view)).x();
  wall.material.translucency = 0.2f;
  const float thin = middle(draw_wall(wall, view)).x();
  EXPECT_LT(opaque, 3);
  EXPECT_GT(thin, 60);
}

// A white cloth must not throw back more light than falls on it, whatever its sheen: the gradient of the tone
// curve makes more light a higher value.
TEST(Material, SheenDoesNotAddEnergy) {
  Surface wall = make_wall();
  wall.material.color = {1, 1, 1};
  View view = view_from_z(4);
  light_head_on(view);
  view.exposure = 0.3f;
  wall.material.sheen = 0;
  const float matte = middle(draw_wall(wall, view)).x();
  wall.material.sheen = 1;
  EXPECT_LE(middle(draw_wall(wall, view)).x(), matte);
}

TEST(Material, CheckerHasBothColoursInEqualParts) {
  Surface wall = make_wall();
  wall.material.color = {0.8f, 0.1f, 0.1f};
  wall.material.accent = {0.1f, 0.1f, 0.8f};
  wall.material.pattern = Pattern::checker;
  wall.material.pattern_scale = 2;
  const Image image = draw_wall(wall, view_from_z(4));
  int red = 0;
  int blue = 0;
  for (int y = 20; y < 76; ++y) {
    for (int x = 20; x < 76; ++x) {
      const Vec3f color = pixel(image, x, y);
      (color.x() > color.z() ? red : blue) += 1;
    }
  }
  EXPECT_NEAR(red, blue, 0.06 * (red + blue));
}

// Threads too fine to see melt into one colour: no moire.
TEST(Material, FinePatternsMelt) {
  for (const Pattern pattern : {Pattern::checker, Pattern::stripe, Pattern::tartan}) {
    Surface wall = make_wall();
    wall.material.pattern = pattern;
    wall.material.pattern_scale = 3001.7f;
    const Image image = draw_wall(wall, view_from_z(4));
    const Vec3f color = middle(image);
    for (int x = 30; x < 66; ++x) EXPECT_LT((pixel(image, x, 40) - color).cwiseAbs().maxCoeff(), 4);
  }
}

TEST(Material, SurfacesWithoutTextureCoordinatesArePlain) {
  Surface wall = make_wall();
  const Image plain = draw_wall(wall, view_from_z(4));
  wall.material.pattern = Pattern::tartan;
  wall.uvs.clear();
  EXPECT_EQ(draw_wall(wall, view_from_z(4)).rgb, plain.rgb);
}

TEST(Material, MoreExposureIsBrighter) {
  View view = view_from_z(4);
  const float normal = middle(draw_wall(make_wall(), view)).x();
  view.exposure = 1.5f;
  EXPECT_GT(middle(draw_wall(make_wall(), view)).x(), normal + 5);
}

}  // namespace
}  // namespace drape::render::test
