#include <gtest/gtest.h>

#include "scene/scene_text.h"

namespace drape {

TEST(Override, SetsAndMakesKeys) {
  const auto scene = load_text(smallest_scene, {"time.step=1 ms", "cloths.a.grid.points=[4, 5]", "name=other",
                                                "render.video.crf=23", "cloths.a.grid.size.1=3"});
  EXPECT_EQ(scene.time.step, 0.001);
  EXPECT_EQ(scene.cloths[0].input.mesh.positions.size(), 20u);
  EXPECT_EQ(scene.name, "other");
  EXPECT_EQ(scene.render.crf, 23);
  EXPECT_EQ(scene.cloths[0].input.mesh.positions.back().z(), 1.5);
}

TEST(Override, ComesBeforeVariables) {
  EXPECT_EQ(load_text("vars: {n: 3}\nname: \"a${n}\"\n" + smallest_scene, {"vars.n=4"}).name, "a4");
}

TEST(Override, TheLastOneWins) {
  EXPECT_EQ(load_text(smallest_scene, {"time.fps=10", "time.fps=20"}).time.fps, 20);
}

TEST(Override, IsCheckedLikeTheFile) {
  EXPECT_EQ(errors_of(smallest_scene, {"time.step=5 mm"}),
            "-D time.step=5 mm: error: time.step must be a time, in s, ms, us, min, not in `mm`");
  EXPECT_EQ(errors_of(smallest_scene, {"time.stp=1"}),
            "-D time.stp=1: error: unknown key `stp` in time; did you mean `step`?");
  EXPECT_EQ(errors_of(smallest_scene, {"cloths.b.material.friction=1"}),
            "-D cloths.b.material.friction=1: error: cloths.b has no shape: give one of grid, disc, mesh");
}

TEST(Override, MustBeAKeyAndAValue) {
  const std::string words = "error: must be key.path=value, such as time.step=1 ms";
  EXPECT_EQ(errors_of(smallest_scene, {"time.step"}), "-D time.step: " + words);
  EXPECT_EQ(errors_of(smallest_scene, {"=1"}), "-D =1: " + words);
  EXPECT_EQ(errors_of(smallest_scene, {"name=[1"}), "-D name=[1: error: the value is not YAML");
  EXPECT_EQ(errors_of(smallest_scene, {"include=[a]"}),
            "-D include=[a]: error: include can be given in files only");
}

TEST(Override, FindsItemsByNumber) {
  EXPECT_EQ(errors_of(smallest_scene, {"cloths.a.grid.size.2=3"}),
            "-D cloths.a.grid.size.2=3: error: `2` must be the number of an item, from 0, in a list of 2");
}

TEST(Override, ProblemsComeAfterThoseOfTheFile) {
  EXPECT_EQ(
      errors_of(smallest_scene + "x: 1\n", {"time.fps=0"}),
      "scene.yaml:3:1: error: unknown key `x` in the scene; known keys: version, name, vars, include, time, "
      "simulation, materials, cloths, seams, colliders, measure, test, camera, lights, render\n"
      "-D time.fps=0: error: time.fps must be from 1 to 1000, but is `0`");
}

}  // namespace drape
