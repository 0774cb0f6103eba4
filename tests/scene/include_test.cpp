#include <gtest/gtest.h>

#include "scene/scene_text.h"

namespace drape {

TEST(Include, MergesDeeplyAndTheIncludingFileWins) {
  const TemporaryFolder folder;
  folder.write("parts/first.yaml", "time: {fps: 10, step: 1 ms}\nname: first\n");
  folder.write("parts/second.yaml", "time: {fps: 20}\ncamera: {fov: 50}\n");
  const auto scene = load_scene(folder.write(
      "scene.yaml", "include: [parts/first.yaml, parts/second.yaml]\nname: own\n" + smallest_scene));
  EXPECT_EQ(scene.time.fps, 20);  // the later of two
  EXPECT_EQ(scene.time.step, 0.001);
  EXPECT_EQ(scene.name, "own");
  EXPECT_EQ(scene.camera.field_of_view, 50);
}

TEST(Include, SharesVariables) {
  const TemporaryFolder folder;
  folder.write("fabrics.yaml", "vars: {silk: {density: 60 g/m2}}\n");
  const auto scene = load_scene(folder.write("scene.yaml", "include: [fabrics.yaml]\n" + smallest_scene),
                                {"cloths.a.material=${silk}"});
  EXPECT_EQ(scene.cloths[0].input.material.elastic.density, 0.06);
}

TEST(Include, PlacesProblemsInTheFileThatHasThem) {
  const TemporaryFolder folder;
  folder.write("part.yaml", "time:\n  fps: fast\n");
  const auto scene = folder.write("scene.yaml", "include: [part.yaml]\nnaem: x\n" + smallest_scene);
  EXPECT_EQ(failure_of(scene, folder.path()).words,
            "scene.yaml:2:1: error: unknown key `naem` in the scene; did you mean `name`?\n"
            "part.yaml:2:8: error: time.fps must be a number, not `fast`");
}

TEST(Include, StaysUnderTheFolder) {
  const TemporaryFolder folder;
  folder.write("outside.yaml", "name: x\n");
  const auto scene = folder.write("inside/scene.yaml", "include: [../outside.yaml]\n" + smallest_scene);
  EXPECT_EQ(failure_of(scene, folder.path()).words,
            "inside/scene.yaml:1:11: error: include must be a file under the scene's folder, not "
            "`../outside.yaml`");
  std::filesystem::create_symlink(folder.path() / "outside.yaml", folder.path() / "inside/link.yaml");
  const auto linked = folder.write("inside/linked.yaml", "include: [link.yaml]\n" + smallest_scene);
  EXPECT_EQ(
      failure_of(linked, folder.path()).words,
      "inside/linked.yaml:1:11: error: include must be a file under the scene's folder, not `link.yaml`");
}

TEST(Include, EndsWhereAFileIncludesItself) {
  const TemporaryFolder folder;
  const auto scene = folder.write("scene.yaml", "include: [scene.yaml, scene.yaml]\n" + smallest_scene);
  const Failure failure = failure_of(scene, folder.path());
  EXPECT_EQ(failure.exit_status, 2);
  EXPECT_NE(failure.words.find("scene.yaml:1:11: error: include: more than 8 deep, or more than 64 files"),
            std::string::npos);
}

TEST(Include, OfAMissingFileHasStatusThree) {
  const TemporaryFolder folder;
  const auto scene = folder.write("scene.yaml", "include: [none.yaml]\n" + smallest_scene);
  const Failure failure = failure_of(scene, folder.path());
  EXPECT_EQ(failure.exit_status, 3);
  EXPECT_EQ(failure.words, "scene.yaml:1:11: error: include: no file `none.yaml`");
}

TEST(Include, IsMissingAndNotOutsideWhereItsFolderIsMissingToo) {
  const TemporaryFolder folder;
  folder.write("scene.yaml", "include: [materials/silk.yaml]\n" + smallest_scene);
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const Failure failure = failure_of("scene.yaml", folder.path());
  std::filesystem::current_path(before);
  EXPECT_EQ(failure.exit_status, 3);
  EXPECT_NE(failure.words.find("include: no file `materials/silk.yaml`"), std::string::npos) << failure.words;
}

}  // namespace drape
