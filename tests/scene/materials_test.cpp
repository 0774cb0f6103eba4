#include <gtest/gtest.h>

#include "scene/scene_text.h"

namespace drape {

static std::string scene_of(const std::string& material) {
  return "version: 1\ncloths:\n  a:\n    grid: {size: [1, 1], points: [3, 3]}\n    material: " + material +
         "\n";
}

static ClothMaterial material_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return load_text(text, overrides).cloths.at(0).input.material;
}

TEST(Materials, AreTakenByName) {
  const std::string text =
      scene_of("silk") + "materials: {silk: {density: 60 g/m2, friction: 0.2}, denim: {density: 0.4}}\n";
  EXPECT_EQ(material_of(text).elastic.density, 0.06);
  EXPECT_EQ(material_of(text).friction, 0.2);
  EXPECT_EQ(material_of(text).elastic.bend_stiffness, ClothMaterial().elastic.bend_stiffness);
  EXPECT_EQ(material_of(text, {"cloths.a.material=denim"}).elastic.density, 0.4);
  EXPECT_EQ(material_of(text, {"materials.silk.density=70 g/m2"}).elastic.density, 0.07);
}

TEST(Materials, ComeFromAFileThatTheSceneCanChange) {
  const TemporaryFolder folder;
  folder.write("silk.yaml", "materials: {silk: {density: 60 g/m2, friction: 0.2}}\n");
  const auto scene = load_scene(folder.write(
      "scene.yaml", "include: [silk.yaml]\nmaterials: {silk: {friction: 0.5}}\n" + scene_of("silk")));
  EXPECT_EQ(scene.cloths.at(0).input.material.elastic.density, 0.06);
  EXPECT_EQ(scene.cloths.at(0).input.material.friction, 0.5);
}

TEST(Materials, AnUnknownNameIsAMistakeWithAWayOut) {
  EXPECT_EQ(errors_of(scene_of("slik") + "materials: {silk: {density: 60 g/m2}}\n"),
            "scene.yaml:5:15: error: cloths.a.material: no material `slik`; did you mean `silk`?");
  EXPECT_EQ(errors_of(scene_of("paper") + "materials: {silk: {}, denim: {}}\n"),
            "scene.yaml:5:15: error: cloths.a.material: no material `paper`; known materials: silk, denim");
  EXPECT_EQ(
      errors_of(scene_of("silk")),
      "scene.yaml:5:15: error: cloths.a.material: no material `silk`, since the scene has no `materials`: "
      "include a file that has them, as materials/silk.yaml does, or give a map");
}

TEST(Materials, AreCheckedWhetherUsedOrNot) {
  EXPECT_EQ(errors_of(smallest_scene + "materials:\n  silk: {densty: 60 g/m2}\n  denim: {bend: -1}\n"),
            "scene.yaml:4:10: error: unknown key `densty` in materials.silk; did you mean `density`?\n"
            "scene.yaml:5:17: error: materials.denim.bend must be from 0 N m to 1 N m, but is `-1`");
  EXPECT_EQ(errors_of(scene_of("[silk]")),
            "scene.yaml:5:15: error: cloths.a.material must be a map, not a list");
}

}  // namespace drape
