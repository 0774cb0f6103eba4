#include "app/batch.h"

#include <gtest/gtest.h>

#include "app/run_program.h"

namespace drape::app {
namespace {
namespace fs = std::filesystem;

TEST(Batch, TellsHowEachSceneEnded) {
  const std::vector<BatchEntry> entries = {{"a.yaml", 0, 65, "out/a/a.mp4"},
                                           {"long_name.yaml", 2, 0, "wrong"}};
  EXPECT_EQ(batch_table(entries),
            "scene           ended                  time  result\n"
            "a.yaml          done                   1:05  out/a/a.mp4\n"
            "long_name.yaml  scene error            0:00  wrong\n");
  EXPECT_EQ(worst_status(entries), 2);
}

TEST(Batch, GoesOnPastABadSceneAndEndsWithTheWorstStatus) {
  const TemporaryFolder folder;
  const std::string missing = (folder / "missing.yaml").string();
  const std::string good = write_scene(folder, "good", 2);
  const Finished run = run_drape({"run", missing, good, "-o", (folder / "out").string()});
  EXPECT_EQ(run.exit_status, 3);
  EXPECT_TRUE(fs::exists(folder / "out/good/good.mp4"));
  EXPECT_NE(run.out.find("file error"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("done"), std::string::npos) << run.out;
}

TEST(Batch, RefusesTwoScenesOfOneName) {
  const TemporaryFolder folder;
  const std::string scene = write_scene(folder, "same", 2);
  EXPECT_EQ(run_drape({"run", scene, scene, "-o", (folder / "out").string()}).exit_status, 2);
}

TEST(Batch, TellsFoldersApartByTheirWholeNames) {
  const TemporaryFolder folder;
  const std::string scene = write_scene(folder, "scene", 1);
  for (const char* name : {"film.1", "film.2"})
    ASSERT_EQ(run_drape({"simulate", scene, "-o", (folder / name).string()}).exit_status, 0);
  const Finished run = run_drape(
      {"run", (folder / "film.1/").string(), (folder / "film.2/").string(), "-o", (folder / "out").string()});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_TRUE(fs::exists(folder / "out/film.1/scene.mp4"));
  EXPECT_TRUE(fs::exists(folder / "out/film.2/scene.mp4"));
}

}  // namespace
}  // namespace drape::app
