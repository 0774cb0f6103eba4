#include <gtest/gtest.h>

#include <cstdlib>

#include "app/run_program.h"

namespace drape::app {
namespace {
namespace fs = std::filesystem;

const fs::path golden = fs::path(DRAPE_SOURCE_DIR) / "tests/app/golden";

Finished run_short_scene(const TemporaryFolder& folder) {
  return run_drape({"run", (golden / "short.yaml").string(), "-o", (folder / "short").string(), "-q"});
}

void update_references(const fs::path& frames) {
  for (const char* name : {"frame_0002.png", "frame_0006.png"})
    fs::copy_file(frames / name, golden / "frames" / name, fs::copy_options::overwrite_existing);
}

// From the scene file to the pixels: simulation, subdivision, shading. DRAPE_UPDATE_GOLDEN=1 makes it anew.
TEST(GoldenScene, AShortSceneLooksAsItsReferencesDo) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_short_scene(folder).exit_status, 0);
  if (std::getenv("DRAPE_UPDATE_GOLDEN")) update_references(folder / "short/frames");
  for (const char* name : {"frame_0002.png", "frame_0006.png"}) {
    const Finished diff = run_drape({"diff", (golden / "frames" / name).string(),
                                     (folder / "short/frames" / name).string(), "--tolerance", "1"});
    EXPECT_EQ(diff.exit_status, 0) << name << ": " << diff.out << diff.err;
  }
}

TEST(GoldenScene, OneFrameIsNotTakenForTheOther) {
  const Finished diff = run_drape({"diff", (golden / "frames/frame_0002.png").string(),
                                   (golden / "frames/frame_0006.png").string(), "--tolerance", "1"});
  EXPECT_EQ(diff.exit_status, 1);
}

}  // namespace
}  // namespace drape::app
