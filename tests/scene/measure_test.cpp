#include <gtest/gtest.h>

#include "scene/scene_text.h"

namespace drape {

static const std::string parts =
    "version: 1\n"
    "cloths: {fabric: {disc: {diameter: 30 cm, edge: 2 cm}}, patch: {disc: {diameter: 10 cm, edge: 2 cm}}}\n"
    "colliders: {ball: {sphere: {radius: 1}}, table: {cylinder: {radius: 9 cm, height: 2 cm}}}\n";

static std::string scene_of(const std::string& drape) { return parts + "measure:\n  drape: " + drape + "\n"; }

TEST(Measure, NamesAClothAndItsTable) {
  EXPECT_FALSE(load_text(parts).drape_test);
  const auto test = load_text(scene_of("{cloth: fabric, support: table}")).drape_test;
  ASSERT_TRUE(test);
  EXPECT_EQ(test->cloth, 0);
  EXPECT_EQ(test->support, 1);
}

TEST(Measure, NeedsBothNames) {
  EXPECT_EQ(errors_of(scene_of("{cloth: fabric}")),
            "scene.yaml:5:3: error: missing key `support` in measure.drape");
}

TEST(Measure, UnknownNamesAreMistakesWithAWayOut) {
  EXPECT_EQ(
      errors_of(scene_of("{cloth: fabrik, support: taable}")),
      "scene.yaml:5:18: error: measure.drape.cloth: `fabrik` is not in cloths; did you mean `fabric`?\n"
      "scene.yaml:5:35: error: measure.drape.support: `taable` is not in colliders; did you mean `table`?");
  EXPECT_EQ(errors_of(smallest_scene + "measure: {drape: {cloth: a, support: table}}\n"),
            "scene.yaml:3:38: error: measure.drape.support: `table` is not in colliders, which has none");
}

TEST(Measure, TheClothLiesOnACylinderThatIsSmaller) {
  EXPECT_EQ(errors_of(scene_of("{cloth: fabric, support: ball}")),
            "scene.yaml:5:35: error: measure.drape.support must be a cylinder, and `ball` is none");
  EXPECT_EQ(
      errors_of(scene_of("{cloth: patch, support: table}")),
      "scene.yaml:5:18: error: measure.drape.cloth: `patch` must be larger than what it lies on, but has "
      "0.007654 m2, and `table` 0.02545 m2");
}

TEST(Measure, MistakesOfWhatItNamesAreToldOnce) {
  const std::string text = scene_of("{cloth: fabric, support: table}");
  EXPECT_EQ(errors_of(text, {"colliders.table.cylinder.radius=0"}),
            "-D colliders.table.cylinder.radius=0: error: colliders.table.cylinder.radius must be from 0.001 "
            "m to 1000 m, but is `0`");
}

}  // namespace drape
