#include <gtest/gtest.h>

#include <algorithm>

#include "app/manifest.h"
#include "app/run_program.h"
#include "core/file.h"
#include "render/png_file.h"

namespace drape::app {
namespace {
namespace fs = std::filesystem;

// A run of the whole program, at which each test looks from its own side.
class Run : public testing::Test {
 protected:
  std::string out(const std::string& name) const { return (folder / ("out/" + name)).string(); }

  TemporaryFolder folder;
  std::string figures = (folder / "figures.csv").string();
  std::string scene = write_scene(folder, "scene", 3);
  Finished finished = run_drape({"run", scene, "-o", out(""), "--stats", figures});
};

TEST_F(Run, MakesFramesCacheVideoAndRecord) {
  EXPECT_EQ(finished.exit_status, 0) << finished.err;
  EXPECT_EQ(finished.out, out("scene.mp4") + "\n");
  for (const char* name :
       {"frames/frame_0001.png", "frames/frame_0003.png", "cache", "scene.mp4", "run.json"}) {
    EXPECT_TRUE(fs::exists(out(name))) << name;
  }
  EXPECT_TRUE(unfinished_files(out("")).empty());
  const render::Image picture = render::read_png(out("frames/frame_0002.png"));
  EXPECT_EQ(picture.width, 64);
  EXPECT_EQ(picture.height, 36);
}

TEST_F(Run, RecordsEachFrameAndStage) {
  const Manifest manifest = *read_manifest(out("run.json"));
  EXPECT_EQ(manifest.frames.size(), 3u);
  for (const auto& [frame, record] : manifest.frames) EXPECT_NE(record.picture_hash, 0u) << frame;
  for (const char* stage : {"simulate", "render", "encode"})
    EXPECT_GT(manifest.stages.at(stage).wall_seconds, 0);
}

TEST_F(Run, WritesTheFiguresAsCsv) {
  const std::string csv = read_file(figures);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  EXPECT_EQ(csv.substr(0, 17), "frame,state_hash,");
}

TEST_F(Run, DrawsASingleFrameAsInTheWholeRun) {
  const std::string still = out("still.png");
  ASSERT_EQ(run_drape({"still", out(""), "-f", "2", "-o", still}).exit_status, 0);
  EXPECT_EQ(read_file(still), read_file(out("frames/frame_0002.png")));
}

TEST_F(Run, ReplacesNoOtherScenesFrames) {
  const fs::path copy = folder / "kept", other = folder / "other.yaml";
  fs::copy(out(""), copy, fs::copy_options::recursive);
  write_file(other, read_file(scene) + "# another\nsimulation: {gravity: [0, -1, 0]}\n");
  const std::string before = content_of_folder(copy / "cache");
  const Finished refused = run_drape({"run", other.string(), "-o", copy.string()});
  EXPECT_EQ(refused.exit_status, 2);
  EXPECT_NE(refused.err.find("kept: error: holds the run of "), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("name another folder with -o, or replace it with --overwrite"),
            std::string::npos);
  EXPECT_EQ(content_of_folder(copy / "cache"), before);
  EXPECT_EQ(run_drape({"simulate", other.string(), "-o", copy.string(), "--overwrite"}).exit_status, 0);
}

TEST_F(Run, WritesNoPictureUnderTheNameOfAnotherFormat) {
  const std::string still = out("still.jpg");
  const Finished refused = run_drape({"still", out(""), "-f", "2", "-o", still});
  EXPECT_EQ(refused.exit_status, 2);
  EXPECT_NE(refused.err.find("a picture is a PNG file: let its name end in .png"), std::string::npos)
      << refused.err;
  EXPECT_FALSE(fs::exists(still));
}

TEST_F(Run, KeepsPicturesThatAreCurrentAndDrawsTheRest) {
  const fs::path second = out("frames/frame_0002.png");
  const std::string before = content_of_folder(out("frames"));
  write_file(second, "not the picture");
  const Finished again = run_drape({"render", out(""), "-v"});
  EXPECT_NE(again.err.find("1 drawn, 2 kept"), std::string::npos) << again.err;
  EXPECT_EQ(content_of_folder(out("frames")), before);
}

TEST_F(Run, PicturesDoNotDependOnChunksOrThreads) {
  const fs::path copy = folder / "copy";
  fs::create_directory(copy);
  fs::copy(out("cache"), copy / "cache");
  for (const char* chunk : {"2/2", "1/2"}) {
    ASSERT_EQ(run_drape({"render", scene, "-o", copy.string(), "--chunk", chunk, "-j", "1"}).exit_status, 0);
  }
  EXPECT_EQ(content_of_folder(copy / "frames"), content_of_folder(out("frames")));
}

TEST_F(Run, OtherLooksAreDrawnAnewFromTheSameCache) {
  const fs::path looks = folder / "looks";
  fs::copy(out(""), looks, fs::copy_options::recursive);
  const Finished again = run_drape({"render", looks.string(), "-v", "-D", "render.exposure=0.5"});
  EXPECT_NE(again.err.find("3 drawn, 0 kept"), std::string::npos) << again.err;
  EXPECT_NE(content_of_folder(looks / "frames"), content_of_folder(out("frames")));
}

TEST_F(Run, ExportsOneFileAFrame) {
  ASSERT_EQ(run_drape({"export", out(""), "-o", out("obj"), "-f", "1,3", "--colliders"}).exit_status, 0);
  EXPECT_EQ(read_file(out("obj/rest.obj")).substr(0, 9), "o napkin\n");
  EXPECT_TRUE(fs::exists(out("obj/frame_0001.obj")));
  EXPECT_FALSE(fs::exists(out("obj/frame_0002.obj")));
  EXPECT_NE(read_file(out("obj/frame_0003.obj")).find("\no ball\n"), std::string::npos);
}

}  // namespace
}  // namespace drape::app
