#include "app/encode.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "app/run_folder.h"
#include "app/run_program.h"
#include "app/subprocess.h"
#include "core/file.h"
#include "render/png_file.h"

namespace drape::app {
namespace {
namespace fs = std::filesystem;

bool is_installed(const std::string& program) {
  return run_process({program, "-version"}, [](std::string_view) {}).was_found;
}

class Encode : public testing::Test {
 protected:
  void write_pictures(int count, int width, int height) {
    render::Image image{width, height,
                        std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), 90)};
    for (int frame = 1; frame <= count; ++frame) {
      render::write_png(folder / ("out/frames/" + frame_file_name(frame, ".png")), image);
    }
  }
  Finished encode() { return run_drape({"encode", scene, "-o", (folder / "out").string()}); }

  TemporaryFolder folder;
  std::string scene = write_scene(folder, "scene", 5);
};

TEST_F(Encode, HasEveryFrameAtTheSpeedOfTheScene) {
  if (!is_installed("ffmpeg") || !is_installed("ffprobe")) GTEST_SKIP() << "ffmpeg is not installed";
  write_pictures(8, 64, 36);  // more than the scene has: what an earlier, longer run left
  ASSERT_EQ(encode().exit_status, 0);
  std::string figures;
  run_process({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
               "stream=width,height,r_frame_rate,nb_read_frames,color_space,pix_fmt", "-of", "csv=p=0",
               (folder / "out/scene.mp4").string()},
              [&](std::string_view line) { figures += line; });
  EXPECT_EQ(figures, "64,36,yuv420p,bt709,24/1,5");
}

TEST_F(Encode, CutsOddSizesToEvenOnes) {
  if (!is_installed("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  write_pictures(5, 33, 17);
  EXPECT_EQ(encode().exit_status, 0);
}

TEST_F(Encode, RefusesMissingPicturesAndMixedSizes) {
  write_pictures(4, 64, 36);
  EXPECT_EQ(encode().exit_status, 3);
  render::Image other{32, 18, std::vector<std::uint8_t>(std::size_t{3} * 32 * 18, 90)};
  render::write_png(folder / "out/frames/frame_0005.png", other);
  const Finished mixed = encode();
  EXPECT_EQ(mixed.exit_status, 3);
  EXPECT_NE(mixed.err.find("frame_0005.png: is not of the first frame's size"), std::string::npos)
      << mixed.err;
}

TEST_F(Encode, SaysWhatToInstallWhereThereIsNoEncoder) {
  write_pictures(5, 64, 36);
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  const Finished finished = encode();
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(finished.exit_status, 6);
  EXPECT_NE(finished.err.find("apt-get install ffmpeg"), std::string::npos) << finished.err;
  EXPECT_TRUE(fs::exists(folder / "out/frames/frame_0005.png"));
  EXPECT_FALSE(fs::exists(folder / "out/scene.mp4"));
}

TEST_F(Encode, ReportsTheEncodersOwnWordsAndLeavesNothingHalfDone) {
  if (!is_installed("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  write_pictures(5, 64, 36);
  const fs::path last = folder / "out/frames/frame_0005.png";
  write_file(last, read_file(last).substr(0, 60));
  const Finished finished = encode();
  EXPECT_EQ(finished.exit_status, 6) << finished.err;
  EXPECT_FALSE(fs::exists(folder / "out/scene.mp4"));
  EXPECT_TRUE(unfinished_files(folder.path()).empty());
}

TEST_F(Encode, TakesNamesThatFfmpegWouldMisread) {
  if (!is_installed("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  write_pictures(5, 64, 36);
  const fs::path odd = folder / "50%d:x";
  fs::rename(folder / "out", odd);
  EXPECT_EQ(run_drape({"encode", scene, "-o", odd.string()}).exit_status, 0);
}

TEST_F(Encode, RefusesPicturesOfOtherSettings) {
  ASSERT_EQ(run_drape({"simulate", scene, "-o", (folder / "out").string()}).exit_status, 0);
  write_pictures(5, 64, 36);
  write_file(scene, read_file(scene) + "simulation: {gravity: [0, -5, 0]}\n");
  const Finished finished = encode();
  EXPECT_EQ(finished.exit_status, 3);
  EXPECT_NE(finished.err.find("of other settings than the scene has now"), std::string::npos) << finished.err;
  EXPECT_FALSE(fs::exists(folder / "out/scene.mp4"));
}

}  // namespace
}  // namespace drape::app
