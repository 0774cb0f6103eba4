#include <gtest/gtest.h>

#include "app/run_program.h"
#include "core/file.h"

namespace drape::app {
namespace {

class Measure : public testing::Test {
 protected:
  Finished measure(std::vector<std::string> flags = {}) {
    flags.insert(flags.begin(), {"measure", scene, "-o", (folder / "out").string()});
    return run_drape(flags);
  }

  TemporaryFolder folder;
  std::string scene = folder
                          .write("test.yaml", R"(version: 1
time: {fps: 25, frames: 2}
cloths:
  fabric:
    disc: {diameter: 30 cm, edge: 2 cm}
    place: {at: [0, 0.005, 0]}
colliders: {table: {cylinder: {radius: 9 cm, height: 2 cm}, place: {at: [0, -0.01, 0]}}}
measure: {drape: {cloth: fabric, support: table}}
)")
                          .string();
};

TEST_F(Measure, PrintsALineForEachFigure) {
  ASSERT_EQ(run_drape({"simulate", scene, "-o", (folder / "out").string()}).exit_status, 0);
  const Finished finished = measure({"-f", "1"});
  EXPECT_EQ(finished.exit_status, 0) << finished.err;
  EXPECT_EQ(finished.out.substr(0, 19), "drape coefficient  ");
  EXPECT_NE(finished.out.find(" %\nfolds              "), std::string::npos) << finished.out;
  EXPECT_NE(finished.err.find("frame 1: the cloth is not at rest"), std::string::npos) << finished.err;
}

TEST_F(Measure, PrintsJsonOfTheLastFrame) {
  ASSERT_EQ(run_drape({"simulate", scene, "-o", (folder / "out").string()}).exit_status, 0);
  const std::string out = measure({"--json"}).out;
  EXPECT_EQ(out.substr(0, 41), R"({"frame": 2, "drape_coefficient_percent":)");
  const std::string last_key = R"(, "folds": )";
  EXPECT_NE(out.find(last_key), std::string::npos) << out;
  EXPECT_EQ(out.substr(out.size() - 2), "}\n");
}

TEST_F(Measure, NeedsASimulationAndATest) {
  EXPECT_EQ(measure().exit_status, 3);
  const Finished finished = run_drape({"measure", write_scene(folder, "napkin", 2)});
  EXPECT_EQ(finished.exit_status, 2);
  EXPECT_NE(finished.err.find("napkin.yaml: error: nothing to measure: give the scene `measure: "),
            std::string::npos)
      << finished.err;
}

}  // namespace
}  // namespace drape::app
