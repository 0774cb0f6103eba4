#include <gtest/gtest.h>

#include <vector>

#include "simulation/shapes_at_rest.h"

namespace drape {
namespace {

using namespace test;

std::vector<Vec3> shape_at_rest(SimulationInput input) {
  Simulation simulation(std::move(input));
  settle(simulation, 1.2);
  return sample_square(simulation, 1, Vec3::Zero(), 12);
}

TEST(Resolution, AHangingSheetHasTheSameShapeInEveryMeshAndStep) {
  const std::vector<Vec3> fine = shape_at_rest(hanging_sheet({32, false, 0.002}));
  for (const MeshAndStep& run : {MeshAndStep{16, false, 0.002}, {16, true, 0.002}, {16, false, 0.005}})
    EXPECT_LT(rms_distance(shape_at_rest(hanging_sheet(run)), fine), 0.001) << run.points << run.irregular;
}

TEST(Resolution, ASheetOverABallHasTheSameShapeInEveryMeshAndStep) {
  const std::vector<Vec3> fine = shape_at_rest(sheet_on_a_ball({32, false, 0.002}));
  for (const MeshAndStep& run : {MeshAndStep{24, false, 0.002}, {24, true, 0.002}, {24, false, 0.005}})
    EXPECT_LT(rms_distance(shape_at_rest(sheet_on_a_ball(run)), fine), 0.01) << run.points << run.irregular;
}

}  // namespace
}  // namespace drape
