// Scenes of scenes/contact that take some seconds: every frame is certified, and shows what the scene says.
// `./dev scenes` has the others too.

#include <gtest/gtest.h>

#include <filesystem>

#include "app/run_program.h"

namespace drape::app {
namespace {

class ContactScene : public testing::TestWithParam<std::string> {};

TEST_P(ContactScene, IsCertifiedAndShowsWhatItSays) {
  const TemporaryFolder folder;
  const std::string run = (folder / "run").string();
  const std::string scene = DRAPE_SOURCE_DIR "/scenes/contact/" + GetParam() + ".yaml";
  const Finished simulated = run_drape({"simulate", "-q", scene, "-o", run});
  ASSERT_EQ(simulated.exit_status, 0) << simulated.err;
  const Finished verified = run_drape({"verify", run});
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ContactScene,
                         testing::Values("bullet", "cone", "funnel", "needles", "turning_sphere"),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace drape::app
