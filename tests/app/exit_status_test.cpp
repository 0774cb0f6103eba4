#include <gtest/gtest.h>

#include "app/run_program.h"
#include "core/file.h"

namespace drape::app {
namespace {

class ExitStatusOfProgram : public testing::Test {
 protected:
  std::string scene_with(const std::string& from, const std::string& to) {
    std::string text = read_file(write_scene(folder, "good", 2));
    text.replace(text.find(from), from.size(), to);
    write_file(folder / "changed.yaml", text);
    return (folder / "changed.yaml").string();
  }

  TemporaryFolder folder;
};

TEST_F(ExitStatusOfProgram, IsZeroForHelpAndVersion) {
  EXPECT_EQ(run_drape({"--help"}).exit_status, 0);
  EXPECT_EQ(run_drape({"--version"}).exit_status, 0);
  EXPECT_EQ(run_drape({"--version"}).out.substr(0, 6), "drape ");
}

TEST_F(ExitStatusOfProgram, IsTwoForUsageAndSceneErrors) {
  EXPECT_EQ(run_drape({}).exit_status, 2);
  EXPECT_EQ(run_drape({"dance"}).exit_status, 2);
  const std::string scene = scene_with("subdivide", "subdivied");
  for (const char* command : {"run", "simulate", "validate", "info"}) {
    const Finished finished = run_drape({command, scene});
    EXPECT_EQ(finished.exit_status, 2) << command;
    EXPECT_NE(finished.err.find("changed.yaml:7:"), std::string::npos) << finished.err;
  }
  EXPECT_EQ(run_drape({"info", write_scene(folder, "good", 2), "-D", "time.step=never"}).exit_status, 2);
}

TEST_F(ExitStatusOfProgram, IsThreeWhereAFileCannotBeReadOrWritten) {
  EXPECT_EQ(run_drape({"run", (folder / "missing.yaml").string()}).exit_status, 3);
  EXPECT_EQ(run_drape({"render", folder.path().string()}).exit_status, 3);
  const std::string scene = write_scene(folder, "good", 2);
  EXPECT_EQ(run_drape({"simulate", scene, "-o", "/proc/drape"}).exit_status, 3);
  EXPECT_EQ(run_drape({"render", scene, "-o", (folder / "empty").string()}).exit_status, 3);
  EXPECT_EQ(run_drape({"encode", scene, "-o", (folder / "empty").string()}).exit_status, 3);
}

TEST_F(ExitStatusOfProgram, ValidateReadsEverySceneAndEndsWithTheWorst) {
  const std::string bad = scene_with("24", "-1");
  const std::string good = (folder / "good.yaml").string();
  EXPECT_EQ(run_drape({"validate", good}).out, good + ": ok\n");
  const Finished both = run_drape({"validate", bad, good});
  EXPECT_EQ(both.exit_status, 2);
  EXPECT_EQ(both.out, good + ": ok\n");
}

TEST_F(ExitStatusOfProgram, InfoCountsWhatWillBeDone) {
  const Finished info = run_drape({"info", write_scene(folder, "good", 12), "-D", "time.step=0.1 ms"});
  EXPECT_EQ(info.exit_status, 0);
  EXPECT_NE(info.out.find("36 points, 50 triangles, 85 edges"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("417 a frame, 5004 in all"), std::string::npos) << info.out;
}

TEST_F(ExitStatusOfProgram, IsThreeWhereTheOutputIsAFile) {
  const std::string scene = write_scene(folder, "good", 2), file = folder.write("plain", "text").string();
  for (const char* command : {"run", "simulate", "render", "encode", "info"}) {
    const Finished finished = run_drape({command, scene, "-o", file});
    EXPECT_EQ(finished.exit_status, 3) << command;
    EXPECT_EQ(finished.err, "drape: error: " + file +
                                ": is a file, not a folder, and nothing can be put into it: name a folder\n")
        << command;
  }
  EXPECT_EQ(read_file(file), "text");
}

TEST_F(ExitStatusOfProgram, IsThreeWhereAPathCannotBeFollowed) {
  const std::string scene = write_scene(folder, "good", 2);
  std::filesystem::create_symlink("loop", folder / "loop");
  EXPECT_EQ(run_drape({"simulate", scene, "-o", (folder / "loop/out").string()}).exit_status, 3);
  std::filesystem::create_directory(folder / "out");
  std::filesystem::create_symlink("cache", folder / "out/cache");
  for (const char* command : {"simulate", "render"})
    EXPECT_EQ(run_drape({command, scene, "-o", (folder / "out").string()}).exit_status, 3) << command;
}

}  // namespace
}  // namespace drape::app
