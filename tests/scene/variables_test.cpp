#include <gtest/gtest.h>

#include "scene/scene_text.h"

namespace drape {

static std::string with_vars(const std::string& vars, const std::string& more = "") {
  return "vars: " + vars + "\n" + smallest_scene + more;
}

TEST(Variables, StandForAnyValue) {
  const auto scene = load_text(
      "vars:\n  n: 5\n  cotton: {density: 300 g/m2}\n  word: drape\n"
      "version: 1\nname: \"${word} of ${n}\"\n"
      "cloths: {a: {grid: {size: [1, 1], points: [\"${n}\", 3]}, material: \"${cotton}\"}}\n");
  EXPECT_EQ(scene.name, "drape of 5");
  EXPECT_EQ(scene.cloths[0].input.mesh.positions.size(), 15u);
  EXPECT_EQ(scene.cloths[0].input.material.elastic.density, 0.3);
}

TEST(Variables, UseThoseAbove) {
  EXPECT_EQ(load_text(with_vars("{a: x, b: \"${a}${a}\"}", "name: \"${b}\"\n")).name, "xx");
  EXPECT_EQ(errors_of(with_vars("{b: \"${a}\", a: x}", "name: \"${b}\"\n")),
            "scene.yaml:1:11: error: no variable `a` above this");
}

TEST(Variables, MustBeKnown) {
  EXPECT_EQ(errors_of(with_vars("{width: 1}", "name: \"${widht}\"\n")),
            "scene.yaml:4:7: error: no variable `widht` above this; did you mean `width`?");
  EXPECT_EQ(errors_of(with_vars("{a: 1}", "name: \"x ${a\"\n")),
            "scene.yaml:4:7: error: `${` without `}` in `x ${a`");
  EXPECT_EQ(errors_of(with_vars("{a: [1]}", "name: \"x ${a}\"\n")),
            "scene.yaml:4:7: error: variable `a` is a list, which cannot stand inside of a text");
  EXPECT_EQ(errors_of(with_vars("3")), "scene.yaml:1:7: error: vars must be a map from names, not `3`");
}

// What the text of a variable that is not there would be as a number, a color or a map is told by nobody.
TEST(Variables, AreOneProblemWhereTheyAreUnknown) {
  const std::string time = "time: {fps: \"${rate}\"}\n";
  EXPECT_EQ(errors_of(smallest_scene + time), "scene.yaml:3:13: error: no variable `rate` above this");
  EXPECT_EQ(errors_of(smallest_scene, {"time.fps=${rate}"}),
            "-D time.fps=${rate}: error: no variable `rate` above this");
  EXPECT_EQ(errors_of(with_vars("{rate: \"${fps}\"}", time)),
            "scene.yaml:1:14: error: no variable `fps` above this");
  EXPECT_EQ(errors_of(with_vars("{rate: \"${fps}\"}", "time: {fps: \"1${rate}\"}\n")),
            "scene.yaml:1:14: error: no variable `fps` above this");
}

TEST(Variables, HideNoOtherProblemWhereTheyAreUnknown) {
  EXPECT_EQ(errors_of(smallest_scene + "time: {fps: \"${rate}\", step: long}\n"),
            "scene.yaml:3:13: error: no variable `rate` above this\n"
            "scene.yaml:3:30: error: time.step must be a time (a number, in s, ms, us, min), not `long`");
  const std::string override = "-D time={fps: \"${rate}\", step: long, stepp: 1}: error: ";
  EXPECT_EQ(errors_of(smallest_scene, {"time={fps: \"${rate}\", step: long, stepp: 1}"}),
            override + "no variable `rate` above this\n" + override +
                "unknown key `stepp` in time; did you mean `step`?\n" + override +
                "time.step must be a time (a number, in s, ms, us, min), not `long`");
}

TEST(Variables, CannotGrowWithoutEnd) {
  std::string text = "{v0: [a, a, a, a]";
  for (int i = 1; i < 30; ++i) {
    const std::string before = "\"${v" + std::to_string(i - 1) + "}\"";
    text += ", v" + std::to_string(i) + ": [" + before + ", " + before + "]";
  }
  EXPECT_NE(errors_of(with_vars(text + "}")).find("more than 100000 values"), std::string::npos);
}

TEST(Variables, CannotNestWithoutEnd) {
  std::string text = "{v0: [a]";
  for (int i = 1; i < 5000; ++i)
    text += ", v" + std::to_string(i) + ": [\"${v" + std::to_string(i - 1) + "}\"]";
  EXPECT_NE(errors_of(with_vars(text + "}")).find("or 64 levels"), std::string::npos);
}

}  // namespace drape
