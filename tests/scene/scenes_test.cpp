// The scenes that come with the program load, and are what their comments say.

#include <gtest/gtest.h>

#include <filesystem>

#include "mesh/manifold.h"
#include "scene/load.h"

namespace drape {
namespace fs = std::filesystem;

static fs::path scenes_folder() { return fs::path(DRAPE_SOURCE_DIR) / "scenes"; }

static std::vector<std::string> scenes() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(scenes_folder()))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem());
  return names;
}

class Scene : public testing::TestWithParam<std::string> {};

TEST_P(Scene, Loads) {
  const auto scene = load_scene(scenes_folder() / (GetParam() + ".yaml"));
  for (const ClothDescription& cloth : scene.cloths)
    EXPECT_TRUE(check_manifold(cloth.input.mesh).empty()) << cloth.input.name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Scene, testing::ValuesIn(scenes()),
                         [](const auto& instance) { return instance.param; });

TEST(Scenes, SphereDrapeHasItsTriangles) {
  const auto scene = load_scene(scenes_folder() / "sphere_drape.yaml");
  EXPECT_EQ(scene.cloths.at(0).input.mesh.triangles.size(), 11'858u);
}

TEST(Scenes, FlagIsHeldAlongItsHoist) {
  const auto scene = load_scene(scenes_folder() / "flag.yaml");
  EXPECT_EQ(scene.cloths.at(0).input.pins.at(0).vertices.size(), 41u);
}

}  // namespace drape
