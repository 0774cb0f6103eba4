#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <thread>

#include "render/fixed_scenes.h"
#include "render/image_difference.h"
#include "render/pass_uniforms.h"
#include "render/rasterizer.h"
#include "render/render_error.h"

namespace drape::render::test {
namespace {

constexpr Settings small{96, 64, 4};

Image draw(const FixedScene& scene, const Settings& settings = small) {
  return Rasterizer().draw(scene.surfaces, scene.view, settings);
}

// A matte wall in even light has one radiance all over, so what a pixel shows tells how much of it is
// covered.
FixedScene even_triangle() {
  FixedScene scene{"", {make_wall()}, view_from_z(4)};
  light_head_on(scene.view);
  Surface& triangle = scene.surfaces[0];
  triangle.positions = {{-0.9f, -0.6f, 0}, {1.0f, -0.7f, 0}, {-0.1f, 0.8f, 0}};
  triangle.normals.assign(3, Vec3f(0, 0, 1));
  triangle.uvs.clear();
  triangle.triangles = {{0, 1, 2}};
  triangle.material.sheen = 0;
  scene.view.backdrop = {0, 0, 0};
  return scene;
}

float cross(const Vec2f& a, const Vec2f& b) { return a.x() * b.y() - a.y() * b.x(); }

TEST(Rasterizer, CoversTheAreaOfATriangle) {
  const FixedScene scene = even_triangle();
  const Settings settings{160, 120, 64};
  const auto corner = [&](int i) { return seen_at(scene.surfaces[0].positions[i], scene.view, settings); };
  const float expected = 0.5f * std::abs(cross(corner(1) - corner(0), corner(2) - corner(0)));
  const Image image = draw(scene, settings);
  const float full = linear_from_srgb(pixel(image, 80, 60) / 255).x();
  float covered = 0;
  for (int y = 0; y < settings.height; ++y) {
    for (int x = 0; x < settings.width; ++x) covered += linear_from_srgb(pixel(image, x, y) / 255).x() / full;
  }
  EXPECT_NEAR(covered / expected, 1, 0.003);
}

TEST(Rasterizer, PutsATriangleWhereTheCameraSeesIt) {
  const FixedScene scene = even_triangle();
  const Image image = draw(scene, {160, 120, 16});
  const Vec2f top = seen_at(scene.surfaces[0].positions[2], scene.view, {160, 120, 16});
  const int x = static_cast<int>(top.x());
  const int y = static_cast<int>(top.y());
  EXPECT_GT(pixel(image, x, y + 3).x(), 100);
  EXPECT_LT(pixel(image, x, y - 3).x(), 1);
}

TEST(Rasterizer, AnEmptySceneIsTheBackdrop) {
  FixedScene scene;
  scene.view.backdrop = {51 / 255.0f, 102 / 255.0f, 204 / 255.0f};
  const Image image = draw(scene);
  ASSERT_EQ(image.rgb.size(), 3u * small.width * small.height);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) EXPECT_EQ(pixel(image, x, y), Vec3f(51, 102, 204));
  }
}

TEST(Rasterizer, EqualArgumentsGiveEqualPictures) {
  const FixedScene scene = fixed_scenes().back();
  Rasterizer rasterizer;
  const Image first = rasterizer.draw(scene.surfaces, scene.view, small);
  EXPECT_EQ(first.rgb, rasterizer.draw(scene.surfaces, scene.view, small).rgb);
  EXPECT_EQ(first.rgb, draw(scene).rgb);
}

TEST(Rasterizer, WhatWasDrawnBeforeLeavesNoTrace) {
  const std::vector<FixedScene> scenes = fixed_scenes();
  Rasterizer rasterizer;
  rasterizer.draw(scenes[4].surfaces, scenes[4].view, {130, 70, 3});
  EXPECT_EQ(rasterizer.draw(scenes[0].surfaces, scenes[0].view, small).rgb, draw(scenes[0]).rgb);
}

TEST(Rasterizer, TwoInOneThreadDoNotDisturbEachOther) {
  const std::vector<FixedScene> scenes = fixed_scenes();
  Rasterizer first;
  Rasterizer second;
  const Image ball = first.draw(scenes[0].surfaces, scenes[0].view, small);
  second.draw(scenes[1].surfaces, scenes[1].view, small);
  EXPECT_EQ(first.draw(scenes[0].surfaces, scenes[0].view, small).rgb, ball.rgb);
}

TEST(Rasterizer, TwoThreadsGiveThePicturesOfOne) {
  const std::vector<FixedScene> scenes = fixed_scenes();
  Image at_once[2];
  std::thread first([&] { at_once[0] = draw(scenes[0]); });
  std::thread second([&] { at_once[1] = draw(scenes[2]); });
  first.join();
  second.join();
  EXPECT_EQ(at_once[0].rgb, draw(scenes[0]).rgb);
  EXPECT_EQ(at_once[1].rgb, draw(scenes[2]).rgb);
}

TEST(Rasterizer, RefusesWhatItCannotDraw) {
  Rasterizer rasterizer;
  EXPECT_THROW(rasterizer.draw({}, {}, {64, 64, 0}), std::invalid_argument);
  EXPECT_THROW(rasterizer.draw({}, {}, {0, 64, 1}), RenderError);
  EXPECT_THROW(rasterizer.draw({}, {}, {100000, 64, 1}), RenderError);
  Surface wall = make_wall();
  wall.normals.pop_back();
  EXPECT_THROW(rasterizer.draw({wall}, {}, small), std::invalid_argument);
  wall = make_wall();
  wall.triangles.push_back({0, 1, 4});
  EXPECT_THROW(rasterizer.draw({wall}, {}, small), std::invalid_argument);
}

TEST(Rasterizer, DrawsOnAfterARefusal) {
  Rasterizer rasterizer;
  EXPECT_THROW(rasterizer.draw({}, {}, {100000, 64, 1}), RenderError);
  const FixedScene scene = fixed_scenes().front();
  EXPECT_EQ(rasterizer.draw(scene.surfaces, scene.view, small).rgb, draw(scene).rgb);
}

TEST(Rasterizer, LooksStraightDown) {
  FixedScene scene = fixed_scenes().front();
  scene.view.camera.eye = {0, 4, 0};
  scene.view.camera.target = {0, 0, 0};
  const Image image = draw(scene);
  const Vec3f middle = pixel(image, small.width / 2, small.height / 2);
  EXPECT_GT((middle - pixel(image, 2, 2)).norm(), 10);
}

}  // namespace
}  // namespace drape::render::test
