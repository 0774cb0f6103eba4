// scenes/reference.yaml is held against the code: it has every key of the table, and each at its default.

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "scene/include.h"
#include "scene/load.h"
#include "scene/scene_keys.h"

namespace drape {
namespace fs = std::filesystem;

static fs::path reference_file() { return fs::path(DRAPE_SOURCE_DIR) / "scenes/reference.yaml"; }

static void collect_keys(const Node& map, const std::string& section, std::set<std::string_view>& paths) {
  for (const MapEntry& entry : map.entries) {
    const Key* key = find_key(section, entry.key);
    if (key == nullptr) continue;
    paths.insert(key->path);
    if (key->kind == KeyKind::section) collect_keys(entry.value, keys_listed_under(*key), paths);
    if (key->kind == KeyKind::named)
      for (const MapEntry& named : entry.value.entries)
        collect_keys(named.value, keys_listed_under(*key), paths);
    if (key->kind == KeyKind::list)
      for (const Node& item : entry.value.items) collect_keys(item, keys_listed_under(*key), paths);
  }
}

TEST(Reference, HasEveryKey) {
  ProblemList problems;
  const auto root = read_tree(reference_file(), problems);
  ASSERT_TRUE(root && problems.empty());
  std::set<std::string_view> paths = {"include"};  // which reading the tree takes out
  collect_keys(*root, "", paths);
  for (const Key& key : scene_keys()) EXPECT_TRUE(paths.contains(key.path)) << key.path << " is missing";
}

// A scene of the same shapes that leaves everything else out.
static SceneDescription defaults() {
  return load_scene(
      fs::path(DRAPE_SOURCE_DIR) / "scenes/reference.yaml",
      {"name=reference", "time={}", "simulation={}", "camera={}", "render={}", "cloths.sheet.material={}",
       "cloths.sheet.look={}", "cloths.sheet.place={}", "colliders.floor={plane: {}}"});
}

static void expect_same(const Look& a, const Look& b) {
  EXPECT_EQ(a.material.color, b.material.color);
  EXPECT_EQ(a.material.back, b.material.back);
  EXPECT_EQ(a.material.accent, b.material.accent);
  EXPECT_EQ(a.material.pattern, b.material.pattern);
  EXPECT_EQ(a.material.pattern_scale, b.material.pattern_scale);
  EXPECT_EQ(a.material.sheen, b.material.sheen);
  EXPECT_EQ(a.material.translucency, b.material.translucency);
  EXPECT_EQ(a.subdivide, b.subdivide);
}

TEST(Reference, HasTheDefaultsOfTime) {
  const TimeSettings time = load_scene(reference_file()).time;
  EXPECT_EQ(time.fps, TimeSettings().fps);
  EXPECT_EQ(time.first_frame, TimeSettings().first_frame);
  EXPECT_EQ(time.last_frame, TimeSettings().last_frame);
  EXPECT_EQ(time.step, TimeSettings().step);
}

TEST(Reference, HasTheDefaultsOfTheSimulation) {
  const SceneDescription scene = load_scene(reference_file()), standard;
  EXPECT_EQ(scene.name, "reference");
  EXPECT_EQ(scene.model, standard.model);
  EXPECT_EQ(scene.alpha, standard.alpha);
  EXPECT_EQ(scene.gravity, standard.gravity);
  EXPECT_EQ(scene.wind.velocity, standard.wind.velocity);
  EXPECT_EQ(scene.wind.gust, standard.wind.gust);
  EXPECT_EQ(scene.wind.gust_size, standard.wind.gust_size);
  EXPECT_EQ(scene.wind.seed, standard.wind.seed);
  EXPECT_EQ(scene.wind.drag, standard.wind.drag);
  EXPECT_EQ(scene.wind.tangential_drag, standard.wind.tangential_drag);
  EXPECT_EQ(scene.wind.lift, standard.wind.lift);
  EXPECT_EQ(scene.self_collision, standard.self_collision);
  EXPECT_EQ(scene.sleep, standard.sleep);
}

TEST(Reference, HasTheDefaultsOfMaterials) {
  const ClothMaterial material = load_scene(reference_file()).cloths.at(0).input.material, standard;
  EXPECT_EQ(material.elastic.density, standard.elastic.density);
  EXPECT_EQ(material.elastic.stretch_stiffness, standard.elastic.stretch_stiffness);
  EXPECT_EQ(material.elastic.shear_stiffness, standard.elastic.shear_stiffness);
  EXPECT_EQ(material.elastic.poisson_ratio, standard.elastic.poisson_ratio);
  EXPECT_EQ(material.elastic.bend_stiffness, standard.elastic.bend_stiffness);
  EXPECT_EQ(material.elastic.damping, standard.elastic.damping);
  EXPECT_EQ(material.elastic.strain_limit, standard.elastic.strain_limit);
  EXPECT_EQ(material.warp, standard.warp);
  EXPECT_EQ(material.thickness, standard.thickness);
  EXPECT_EQ(material.friction, standard.friction);
}

TEST(Reference, HasTheDefaultsOfColliders) {
  const auto colliders = load_scene(reference_file()).colliders;
  const ColliderDescription standard;
  EXPECT_EQ(colliders.at(0).input.friction, standard.input.friction);
  EXPECT_EQ(colliders.at(0).visible, standard.visible);
  for (const ColliderDescription& collider : colliders) {
    EXPECT_EQ(collider.input.motion.at, standard.input.motion.at);
    EXPECT_EQ(collider.input.motion.rotate, standard.input.motion.rotate);
    EXPECT_TRUE(is_static(collider.input.motion));
  }
}

TEST(Reference, HasTheDefaultsOfLooks) {
  const auto scene = load_scene(reference_file());
  expect_same(scene.cloths.at(0).look, ClothDescription().look);
  expect_same(scene.colliders.at(0).look, ColliderDescription().look);
}

TEST(Reference, HasTheDefaultsOfTheCamera) {
  const CameraDescription camera = load_scene(reference_file()).camera, standard;
  const CameraDescription::Orbit orbit = camera.orbit.value(), standard_orbit;
  EXPECT_EQ(camera.at, standard.at);
  EXPECT_EQ(camera.look_at, standard.look_at);
  EXPECT_EQ(camera.field_of_view, standard.field_of_view);
  EXPECT_EQ(orbit.radius, standard_orbit.radius);
  EXPECT_EQ(orbit.height, standard_orbit.height);
  EXPECT_EQ(orbit.start, standard_orbit.start);
  EXPECT_EQ(orbit.turns, standard_orbit.turns);
}

TEST(Reference, HasTheDefaultsOfLights) {
  const SceneDescription scene = load_scene(reference_file()), standard;
  EXPECT_EQ(scene.sun.direction, standard.sun.direction);
  EXPECT_EQ(scene.sun.color, standard.sun.color);
  EXPECT_EQ(scene.sun.intensity, standard.sun.intensity);
  EXPECT_EQ(scene.sun.size, standard.sun.size);
  EXPECT_EQ(scene.sky.top, standard.sky.top);
  EXPECT_EQ(scene.sky.horizon, standard.sky.horizon);
  EXPECT_EQ(scene.sky.ground, standard.sky.ground);
  EXPECT_EQ(scene.sky.intensity, standard.sky.intensity);
}

TEST(Reference, HasTheDefaultsOfPictures) {
  const RenderDescription render = load_scene(reference_file()).render, standard;
  EXPECT_EQ(render.width, standard.width);
  EXPECT_EQ(render.height, standard.height);
  EXPECT_EQ(render.quality, standard.quality);
  EXPECT_EQ(render.crf, standard.crf);
  EXPECT_EQ(render.exposure, standard.exposure);
  EXPECT_EQ(render.backdrop, standard.backdrop);
}

// Another way round, which also sees a new value that the tests above do not know.
TEST(Reference, MovesAsIfItsDefaultsWereLeftOut) {
  EXPECT_EQ(simulation_fingerprint(load_scene(reference_file())), simulation_fingerprint(defaults()));
}

}  // namespace drape
