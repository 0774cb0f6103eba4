// The scenes that come with the program load, and are what their comments say.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "mesh/manifold.h"
#include "mesh/shadow.h"
#include "scene/load.h"

namespace drape {
namespace fs = std::filesystem;

static fs::path scenes_folder() { return fs::path(DRAPE_SOURCE_DIR) / "scenes"; }

// Those of the folder, of scenes/paper and of scenes/contact; scenes/materials and the walker have only parts
// to include.
static std::vector<std::string> scenes() {
  std::vector<std::string> names;
  for (const fs::path folder : {".", "paper", "contact"})
    for (const auto& entry : fs::directory_iterator(scenes_folder() / folder))
      if (entry.path().extension() == ".yaml" && entry.path().stem() != "walker")
        names.push_back((folder / entry.path().stem()).lexically_normal());
  return names;
}

class Scene : public testing::TestWithParam<std::string> {};

TEST_P(Scene, Loads) {
  const auto scene = load_scene(scenes_folder() / (GetParam() + ".yaml"));
  if (GetParam().starts_with("contact/")) {
    EXPECT_FALSE(scene.facts.empty());
  }
  for (const ClothDescription& cloth : scene.cloths)
    EXPECT_TRUE(check_manifold(cloth.input.mesh).empty()) << cloth.input.name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Scene, testing::ValuesIn(scenes()), [](const auto& instance) {
  std::string name = instance.param;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
});

TEST(Scenes, SphereDrapeHasItsTriangles) {
  const auto scene = load_scene(scenes_folder() / "sphere_drape.yaml");
  EXPECT_EQ(scene.cloths.at(0).input.mesh.triangles.size(), 11'858u);
}

TEST(Scenes, FlagIsHeldAlongItsHoist) {
  const auto scene = load_scene(scenes_folder() / "flag.yaml");
  EXPECT_EQ(scene.cloths.at(0).input.pins.at(0).vertices.size(), 41u);
}

// BS 5058: a piece of 30 cm on a disc of 18 cm.
TEST(Scenes, CusickIsTheTestOfTheStandard) {
  const auto scene = load_scene(scenes_folder() / "cusick.yaml");
  const DrapeTest test = scene.drape_test.value();
  const ClothInput& fabric = scene.cloths.at(test.cloth).input;
  const ColliderInput& table = scene.colliders.at(test.support).input;
  const double radius = std::get<CylinderShape>(table.shape).radius;
  EXPECT_EQ(radius, 0.09);
  EXPECT_NEAR(surface_area(fabric.mesh.positions, fabric.mesh.triangles), std::numbers::pi * 0.15 * 0.15,
              2e-5);

  std::size_t held = 0;
  for (const PinInput& pin : fabric.pins) {
    held += pin.vertices.size();
    for (const int vertex : pin.vertices) EXPECT_LT(fabric.mesh.positions[vertex].norm(), radius);
  }
  std::size_t on_table = 0;
  for (const Vec3& p : fabric.mesh.positions) on_table += p.norm() < radius;
  EXPECT_GT(double(held), 0.85 * double(on_table));
}

TEST(Scenes, CusickKnowsEveryMaterial) {
  int files = 0;
  for (const auto& entry : fs::directory_iterator(scenes_folder() / "materials")) {
    const std::string override_text = "cloths.fabric.material=" + entry.path().stem().string();
    EXPECT_NO_THROW(load_scene(scenes_folder() / "cusick.yaml", {override_text})) << override_text;
    ++files;
  }
  EXPECT_GE(files, 6);
}

}  // namespace drape
