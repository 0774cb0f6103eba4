#include <gtest/gtest.h>

#include <csignal>

#include "app/manifest.h"
#include "app/run_program.h"
#include "render/png_file.h"
#include "simulation/cache.h"

namespace drape::app {
namespace {
namespace fs = std::filesystem;

class Interrupt : public testing::Test {
 protected:
  std::string out(const std::string& name) { return (folder / name).string(); }
  TemporaryFolder folder;
};

TEST_F(Interrupt, StopsTheSimulationAfterACheckpoint) {
  const std::string scene = write_scene(folder, "scene", 2000, 10);
  EXPECT_EQ(stop_drape({"simulate", scene, "-q", "-o", out("stopped")},
                       cached_frame_path(out("stopped/cache"), 2), SIGTERM),
            143);
  const Manifest stopped = *read_manifest(out("stopped/run.json"));
  const int reached = stopped.frames.rbegin()->first;
  ASSERT_LT(reached, 2000);
  EXPECT_EQ(read_checkpoint(out("stopped/cache"), stopped.fingerprint)->frame, reached);
  EXPECT_TRUE(unfinished_files(folder.path()).empty());

  const std::string frames = "time.frames=1-" + std::to_string(reached + 3);
  EXPECT_EQ(run_drape({"simulate", out("stopped"), "-D", frames}).exit_status, 0);
  EXPECT_EQ(run_drape({"simulate", scene, "-o", out("whole"), "-D", frames}).exit_status, 0);
  EXPECT_EQ(content_of_folder(out("stopped/cache")), content_of_folder(out("whole/cache")));
}

TEST_F(Interrupt, LeavesWholePicturesAndGoesOnFromThere) {
  const std::string scene = write_scene(folder, "scene", 30);
  const fs::path third = folder / "stopped/frames/frame_0003.png";
  EXPECT_EQ(stop_drape({"run", scene, "-q", "-o", out("stopped")}, third, SIGINT), 130);
  EXPECT_TRUE(unfinished_files(folder.path()).empty());
  int pictures = 0;
  for (const auto& entry : fs::directory_iterator(out("stopped/frames"))) {
    if (!entry.is_regular_file()) continue;
    EXPECT_EQ(render::read_png(entry.path()).width, 64) << entry.path();
    ++pictures;
  }
  EXPECT_LT(pictures, 30);
  EXPECT_FALSE(fs::exists(out("stopped/scene.mp4")));
  const Finished rest = run_drape({"render", out("stopped"), "-v"});
  EXPECT_NE(rest.err.find(std::to_string(30 - pictures) + " drawn"), std::string::npos) << rest.err;
}

}  // namespace
}  // namespace drape::app
