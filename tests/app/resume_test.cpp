#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "app/manifest.h"
#include "app/run_program.h"
#include "core/file.h"
#include "simulation/cache.h"

namespace drape::app {
namespace {
namespace fs = std::filesystem;

class Resume : public testing::Test {
 protected:
  Finished simulate(const std::string& output, int frames) {
    return run_drape({"simulate", scene, "-o", (folder / output).string(), "-D",
                      "time.frames=1-" + std::to_string(frames)});
  }
  Manifest manifest(const std::string& output) { return *read_manifest(folder / (output + "/run.json")); }

  TemporaryFolder folder;
  std::string scene = write_scene(folder, "scene", 12, 10);
};

TEST_F(Resume, GivesTheBitsOfARunThatWasNeverStopped) {
  ASSERT_EQ(simulate("whole", 12).exit_status, 0);
  ASSERT_EQ(simulate("parts", 5).exit_status, 0);
  const Finished second = simulate("parts", 12);
  EXPECT_NE(second.err.find("goes on after frame 5"), std::string::npos) << second.err;
  EXPECT_EQ(content_of_folder(folder / "parts/cache"), content_of_folder(folder / "whole/cache"));
  const Manifest parts = manifest("parts");
  ASSERT_EQ(parts.frames.size(), 12u);
  for (const auto& [frame, record] : manifest("whole").frames) {
    EXPECT_EQ(parts.frames.at(frame).state_hash, record.state_hash) << frame;
    EXPECT_EQ(parts.frames.at(frame).statistics.contacts, record.statistics.contacts) << frame;
  }
}

TEST_F(Resume, GoesOnWhereClothSleepsAndSaysThatItDoes) {
  scene = folder.write("still.yaml", R"(version: 1
time: {fps: 30, frames: 60}
cloths:
  sheet: {grid: {size: [0.2, 0.2], points: [5, 5]}, place: {at: [0, 0.01, 0]}}
colliders:
  floor: {plane: {y: 0}}
)");
  const Finished whole = simulate("whole", 60);
  EXPECT_NE(whole.err.find("simulate  cloth lay still in "), std::string::npos) << whole.err;
  EXPECT_NE(whole.err.find(" of 60 frames, which took no step"), std::string::npos) << whole.err;
  ASSERT_EQ(simulate("parts", 50).exit_status, 0);
  ASSERT_EQ(simulate("parts", 60).exit_status, 0);
  EXPECT_EQ(content_of_folder(folder / "parts/cache"), content_of_folder(folder / "whole/cache"));
}

TEST_F(Resume, DoesNothingWhereAllIsDone) {
  simulate("out", 5);
  const std::string before = read_file(folder / "out/run.json");
  EXPECT_NE(simulate("out", 5).err.find("every frame is in the cache already"), std::string::npos);
  EXPECT_EQ(read_file(folder / "out/run.json"), before);
}

TEST_F(Resume, NeverMixesFramesOfTwoSettings) {
  simulate("out", 5);
  const auto before = manifest("out").frames.at(5).state_hash;
  const Finished other = run_drape({"simulate", scene, "-o", (folder / "out").string(), "-D",
                                    "time.frames=1-5", "-D", "time.step=0.2 ms"});
  EXPECT_EQ(other.exit_status, 0);
  EXPECT_EQ(other.err.find("goes on"), std::string::npos);
  EXPECT_NE(manifest("out").frames.at(5).state_hash, before);
  // The pictures of the first settings can no longer be drawn, and the program says so.
  EXPECT_EQ(run_drape({"render", scene, "-o", (folder / "out").string()}).exit_status, 3);
}

TEST_F(Resume, StartsAnewWhereAFrameIsDamaged) {
  simulate("whole", 12);
  simulate("out", 5);
  const fs::path frame = cached_frame_path(folder / "out/cache", 3);
  write_file(frame, read_file(frame).substr(0, 100));
  EXPECT_EQ(simulate("out", 12).exit_status, 0);
  EXPECT_EQ(content_of_folder(folder / "out/cache"), content_of_folder(folder / "whole/cache"));
}

TEST_F(Resume, StartsAnewWhereTheCheckpointIsDamaged) {
  simulate("out", 5);
  const fs::path checkpoint = folder / "out/cache/checkpoint.drape";
  ASSERT_TRUE(fs::exists(checkpoint));
  write_file(checkpoint, read_file(checkpoint).substr(0, 100));
  const Finished again = simulate("out", 6);
  EXPECT_EQ(again.exit_status, 0);
  EXPECT_NE(again.err.find("warning"), std::string::npos);
}

TEST_F(Resume, StartsAnewAfterAnotherBuildUnlessToldOtherwise) {
  simulate("out", 5);
  Manifest changed = manifest("out");
  changed.build = 1;
  write_manifest(folder / "out/run.json", changed);
  const Finished resumed =
      run_drape({"simulate", (folder / "out").string(), "--resume", "-D", "time.frames=1-6"});
  EXPECT_NE(resumed.err.find("goes on after frame 5"), std::string::npos) << resumed.err;
  write_manifest(folder / "out/run.json", changed);
  EXPECT_NE(simulate("out", 6).err.find("another build"), std::string::npos);
}

TEST_F(Resume, AMistakenRenderOrEncodeCostsNothing) {
  simulate("out", 5);
  const std::string before = read_file(folder / "out/run.json");
  for (const char* command : {"render", "encode"}) {
    EXPECT_EQ(run_drape({command, (folder / "out").string(), "-D", "time.step=1 ms"}).exit_status, 3);
    EXPECT_EQ(read_file(folder / "out/run.json"), before) << command;
  }
  EXPECT_NE(simulate("out", 5).err.find("every frame is in the cache already"), std::string::npos);
}

TEST_F(Resume, ARenderThatDrawsNothingLeavesTheRecord) {
  simulate("out", 5);
  const std::string before = read_file(folder / "out/run.json");
  fs::remove(cached_frame_path(folder / "out/cache", 1));
  const std::string out = (folder / "out").string();
  EXPECT_EQ(run_drape({"render", out, "-f", "1", "-D", "render.exposure=0.5"}).exit_status, 3);
  EXPECT_EQ(read_file(folder / "out/run.json"), before);
}

TEST_F(Resume, StartingAnewLeavesTheFilesOfOthers) {
  simulate("out", 5);
  write_file(folder / "out/cache/notes.txt", "mine");
  write_file(folder / "out/cache/more/frame_0001.drape", "mine");
  write_file(folder / "out/cache/frame_0002.drape.part77", "what a crash left");
  const Finished anew =
      run_drape({"simulate", scene, "-o", (folder / "out").string(), "-D", "time.frames=1-2", "--overwrite"});
  EXPECT_EQ(anew.exit_status, 0) << anew.err;
  EXPECT_TRUE(fs::exists(folder / "out/cache/notes.txt"));
  EXPECT_TRUE(fs::exists(folder / "out/cache/more/frame_0001.drape"));
  EXPECT_FALSE(fs::exists(cached_frame_path(folder / "out/cache", 5)));
  EXPECT_TRUE(unfinished_files(folder / "out").empty());
}

TEST_F(Resume, AFailureNamesTheFrameThatFailed) {
  simulate("out", 5);
  const std::uint64_t fingerprint = manifest("out").fingerprint;
  State state = *read_checkpoint(folder / "out/cache", fingerprint);
  state.velocities.front().x() = std::numeric_limits<double>::quiet_NaN();
  write_checkpoint(folder / "out/cache", fingerprint, state);
  const Finished failed = simulate("out", 6);
  EXPECT_EQ(failed.exit_status, 4);
  EXPECT_NE(failed.err.find("frame 6:"), std::string::npos) << failed.err;
}

}  // namespace
}  // namespace drape::app
