#include <gtest/gtest.h>

#include <numeric>

#include "contact/patches.h"
#include "scene.h"

namespace drape {
namespace {

using test::Scene;

Scene several_bodies() {
  Scene scene;
  scene.add_cloth(make_grid({1, 1}, {17, 17}), 0.01);
  scene.add_cloth(make_grid({1, 1}, {5, 5}), 0.01);
  scene.add_mesh(make_box({1, 1, 1}));
  scene.add_sphere({0, 0, 0}, 1);
  scene.add_capsule({0, 0, 0}, {1, 0, 0}, 1);
  scene.add_plane();
  return scene;
}

// Each of 0 .. count - 1 once.
void expect_each_once(std::vector<int> found, std::size_t count) {
  std::sort(found.begin(), found.end());
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(found, all);
}

TEST(Patches, EachPrimitiveIsInOne) {
  const Scene scene = several_bodies();
  std::vector<int> points, edges, triangles;
  for (const Patch& patch : cut_into_patches(scene.geometry)) {
    points.insert(points.end(), patch.points.begin(), patch.points.end());
    edges.insert(edges.end(), patch.edges.begin(), patch.edges.end());
    triangles.insert(triangles.end(), patch.triangles.begin(), patch.triangles.end());
  }
  expect_each_once(points, scene.geometry.vertex_body.size());
  expect_each_once(edges, scene.geometry.edges.size());
  expect_each_once(triangles, scene.geometry.triangles.size());
}

TEST(Patches, HaveAllVerticesOfTheirPrimitivesAllOfOneBody) {
  const Scene scene = several_bodies();
  for (const Patch& patch : cut_into_patches(scene.geometry)) {
    const auto has = [&](int v) {
      return std::binary_search(patch.vertices.begin(), patch.vertices.end(), v);
    };
    for (const int v : patch.points) EXPECT_TRUE(has(v));
    for (const int e : patch.edges)
      for (const int v : scene.geometry.edges[e]) EXPECT_TRUE(has(v));
    for (const int t : patch.triangles)
      for (const int v : scene.geometry.triangles[t]) EXPECT_TRUE(has(v));
    for (const int v : patch.vertices) EXPECT_EQ(scene.geometry.vertex_body[v], patch.body);
  }
}

TEST(Patches, AreSmallAndCompact) {
  const Scene scene = several_bodies();
  const std::vector<Patch> patches = cut_into_patches(scene.geometry);
  EXPECT_LT(patches.size(), 16 + 2 + 3 + 1);
  for (const Patch& patch : patches) {
    if (patch.body != 0) continue;
    const Bounds box = bounds_of(scene.geometry.rest_positions, patch.points);
    EXPECT_GE(patch.points.size(), 10u);
    EXPECT_LE((box.upper - box.lower).maxCoeff(), 0.32);
  }
}

}  // namespace
}  // namespace drape
