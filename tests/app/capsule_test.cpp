#include "app/capsule.h"

#include <gtest/gtest.h>

#include <limits>

#include "app/run_program.h"
#include "app/simulate.h"
#include "core/error.h"
#include "core/file.h"
#include "render/png_file.h"
#include "scene/load.h"

namespace drape::app {
namespace {
namespace fs = std::filesystem;

// Boxes press a sheet until less than its thickness is left between them.
constexpr const char* squeezed = R"(version: 1
time: {fps: 30, frames: 40, step: 2 ms}
cloths:
  sheet:
    grid: {size: [0.3, 0.3], points: [12, 12]}
    place: {at: [0, 0.155, 0]}
    material: {thickness: 4 mm}
colliders:
  anvil: {box: {size: [0.2, 0.1, 0.2]}, place: {at: [0, 0.1, 0]}}
  press:
    box: {size: [0.2, 0.1, 0.2]}
    place: {at: [0, 0.25, 0]}
    animate: {translate: [[0, [0, 0, 0]], [30, [0, -0.049, 0]]]}
)";

class Capsule : public testing::Test {
 protected:
  app::Run open() {
    write_file(folder / "squeezed.yaml", squeezed);
    return open_run((folder / "squeezed.yaml").string(), {}, (folder / "run").string());
  }
  // What the program would say.
  std::string failure_without_fail_safe() {
    app::Run run = open();
    run.scene.fail_safe = false;
    try {
      simulate(run, {}, {-1, false, ProgressStyle::none});
    } catch (const SimulationError& error) {
      return error.what();
    }
    return "";
  }
  fs::path capsule(const std::string& file) { return folder / "run/failure" / file; }

  TemporaryFolder folder;
};

TEST_F(Capsule, IsNotWrittenWhereAllFramesAreGood) {
  app::Run run = open();
  simulate(run, {}, {-1, false, ProgressStyle::none});
  EXPECT_EQ(run.manifest.frames.size(), 40u);
  EXPECT_FALSE(fs::exists(folder / "run/failure"));
}

// It is the fail-safe that keeps this scene whole, and the certificate sees when it does not.
TEST_F(Capsule, StopsARunWithoutFailSafeAndSaysAllThatIsNeeded) {
  const std::string words = failure_without_fail_safe();
  const std::string run = (folder / "run").string();
  EXPECT_EQ(words.find("frame "), 0u) << words;
  EXPECT_NE(words.find(": something is through something: triangle "), std::string::npos) << words;
  EXPECT_NE(words.find("; " + run +
                       "/failure holds the state before, both shapes, all faults and a picture of them;"),
            std::string::npos)
      << words;
  EXPECT_NE(words.find("'drape simulate " + run + "' makes the frame again"), std::string::npos) << words;
  EXPECT_EQ(read_file(capsule("command.txt")), "drape simulate " + run + "\n");
  EXPECT_EQ(read_file(capsule("faults.txt")).find("triangle "), 0u);
  EXPECT_TRUE(fs::exists(capsule("before.obj")));
  EXPECT_TRUE(fs::exists(capsule("after.obj")));
  EXPECT_GT(render::read_png(capsule("faces.png").string()).rgb.size(), 0u);
}

TEST_F(Capsule, HoldsTheStateBeforeAndTheRunGoesOnFromIt) {
  const std::string words = failure_without_fail_safe();
  const app::Run run = open();
  const auto kept = read_checkpoint(folder / "run/failure", run.manifest.fingerprint);
  const auto next = read_checkpoint(run.folder.cache(), run.manifest.fingerprint);
  ASSERT_TRUE(kept && next);
  EXPECT_EQ(state_hash(*kept), state_hash(*next));
  EXPECT_EQ(words.find("frame " + std::to_string(kept->frame + 1) + ":"), 0u) << words;
  EXPECT_EQ(failure_without_fail_safe(), words);
  const auto again = read_checkpoint(folder / "run/failure", run.manifest.fingerprint);
  ASSERT_TRUE(again);
  EXPECT_EQ(state_hash(*again), state_hash(*kept));
}

TEST_F(Capsule, NamesPointsThatAreNotFinite) {
  const app::Run run = open();
  Simulation simulation(simulation_input(run.scene));
  State after = simulation.state();
  after.positions[6].x() = std::numeric_limits<double>::quiet_NaN();
  try {
    stop_with_capsule(run, {simulation.state(), after, {}, "values are not finite"});
  } catch (const SimulationError& error) {
    EXPECT_NE(std::string(error.what()).find("frame 1: values are not finite: point 7 is not finite; "),
              std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(fs::exists(capsule("faces.png")));
}

}  // namespace
}  // namespace drape::app
