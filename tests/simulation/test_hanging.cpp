#include <gtest/gtest.h>

#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

// A square metre of cloth that hangs from the vertices that `pinned` picks.
template <typename Pinned>
SimulationInput hanging_sheet(int points, const Pinned& pinned) {
  ClothInput cloth = standing_sheet(1, points, 0);
  PinInput pin;
  for (int v = 0; v < points * points; ++v)
    if (pinned(v % points, v / points)) pin.vertices.push_back(v);
  cloth.pins.push_back(pin);
  SimulationInput input = simulate_alone(cloth);
  input.self_collision = false;
  return input;
}

TEST(Hanging, ASheetPinnedAlongItsTopComesToRestWithinOnePercent) {
  Simulation simulation(hanging_sheet(32, [](int, int row) { return row == 31; }));
  const FrameStatistics statistics = advance(simulation, 150);
  EXPECT_LT(statistics.largest_stretch, 1.01);
  EXPECT_GT(statistics.smallest_stretch, 0.99);
  EXPECT_LT(statistics.largest_speed, 0.01);
}

FrameStatistics hung_from_two_corners(int points, double seconds) {
  SimulationInput input = hanging_sheet(points, [&](int column, int row) {
    return row == points - 1 && (column == 0 || column == points - 1);
  });
  input.frame_duration = input.largest_step = 0.005;
  Simulation simulation(input);
  return advance(simulation, static_cast<int>(seconds / 0.005));
}

TEST(Hanging, ASheetPinnedAtTwoCornersComesToRestAndHardlyStretches) {
  const FrameStatistics statistics = hung_from_two_corners(32, 5);
  EXPECT_LT(statistics.p99_stretch, 1.002);
  EXPECT_LT(statistics.largest_stretch, 1.01);
  EXPECT_LT(statistics.largest_speed, 0.01);
}

TEST(Hanging, AFineSheetStretchesHardlyMore) {
  const FrameStatistics statistics = hung_from_two_corners(128, 0.4);
  EXPECT_LT(statistics.p99_stretch, 1.003);
  EXPECT_LT(statistics.largest_stretch, 1.02);
}

TEST(Hanging, PinnedPointsStayWhereTheyAreToTheBit) {
  const SimulationInput input = hanging_sheet(10, [](int, int row) { return row == 9; });
  Simulation simulation(input);
  advance(simulation, 10);
  for (const int v : input.cloths[0].pins[0].vertices)
    EXPECT_EQ(simulation.state().positions[v], input.cloths[0].start_positions[v]);
}

TEST(Hanging, APinFollowsItsKeyframes) {
  SimulationInput input = hanging_sheet(10, [](int, int row) { return row == 9; });
  RigidMotion motion;
  motion.translate[0] = {{0.0, 0.0}, {0.5, 0.2}};
  input.cloths[0].pins[0].motion = motion;
  Simulation simulation(input);
  advance(simulation, 15);
  const int v = input.cloths[0].pins[0].vertices[3];
  EXPECT_NEAR(simulation.state().positions[v].x(), input.cloths[0].start_positions[v].x() + 0.2, 1e-9);
}

TEST(Hanging, APinLetsGoAtItsTime) {
  SimulationInput input = hanging_sheet(10, [](int, int row) { return row == 9; });
  input.cloths[0].pins[0].until = 10 * input.frame_duration;
  Simulation simulation(input);
  const int v = input.cloths[0].pins[0].vertices[0];
  advance(simulation, 10);
  EXPECT_EQ(simulation.state().positions[v], input.cloths[0].start_positions[v]);
  advance(simulation, 10);
  EXPECT_LT(simulation.state().positions[v].y(), input.cloths[0].start_positions[v].y() - 0.1);
}

TEST(Hanging, AHeavyRubberSheetStretchesAsItsStiffnessSays) {
  SimulationInput input = hanging_sheet(24, [](int, int row) { return row == 23; });
  input.cloths[0].material.elastic.density = 2;
  input.cloths[0].material.elastic.stretch_stiffness = {1000, 1000};
  Simulation simulation(input);
  const FrameStatistics statistics = advance(simulation, 240);
  // At the top the weight of a square metre of 2 kg hangs on a metre: a strain of 2 * 9.81 / 1000 for one
  // layer of stiffness. Clusters and fibres both carry, so it is less; it must be of that size all the same.
  EXPECT_GT(statistics.largest_stretch, 1.004);
  EXPECT_LT(statistics.largest_stretch, 1.03);
}

}  // namespace
}  // namespace drape
