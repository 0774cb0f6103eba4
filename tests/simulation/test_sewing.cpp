#include <gtest/gtest.h>

#include <algorithm>

#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

// Two sheets over each other, to be sewn along the row of each at -z.
SimulationInput two_sheets() {
  SimulationInput input;
  input.gravity.setZero();
  remove_air(input);
  input.cloths = {sheet(0.3, 9, 0), sheet(0.3, 9, 0.1)};
  SeamInput seam{};
  seam.cloths = {0, 1};
  for (int v = 0; v < 9; ++v)
    for (std::vector<int>& side : seam.vertices) side.push_back(v);
  seam.close = 15 * input.frame_duration;
  input.seams.push_back(seam);
  return input;
}

double widest_pair(const Simulation& simulation) {
  double widest = 0;
  for (std::size_t v = 0; v < 9; ++v)
    widest =
        std::max(widest, (simulation.state().positions[v] - simulation.state().positions[v + 81]).norm());
  return widest;
}

TEST(Sewing, ClosesASeamToTheThicknessThatContactKeeps) {
  Simulation simulation(two_sheets());
  advance(simulation, 7);
  EXPECT_GT(widest_pair(simulation), 0.05);  // not all at once
  advance(simulation, 23);
  EXPECT_NEAR(widest_pair(simulation), 0.005, 0.001);
  EXPECT_EQ(intersecting_pairs(simulation), 0);
}

TEST(Sewing, KeepsLinearMomentum) {
  Simulation simulation(two_sheets());
  advance(simulation, 30);
  EXPECT_LT(linear_momentum(simulation).norm(), 1e-10);
}

TEST(Sewing, HoldsAClothThatHangsFromAnother) {
  SimulationInput input = two_sheets();
  input.gravity = Vec3(0, -9.81, 0);
  for (int v = 0; v < 81; ++v) input.cloths[1].pins.resize(1), input.cloths[1].pins[0].vertices.push_back(v);
  Simulation simulation(input);
  advance(simulation, 45);
  EXPECT_NEAR(widest_pair(simulation), 0.005, 0.001);
}

// The threads' first lengths are part of the state.
TEST(Sewing, ResumesWithTheSameBits) {
  SimulationInput input = two_sheets();
  input.seams[0].from = 3 * input.frame_duration;
  Simulation whole(input);
  for (int frame = 0; frame < 6; ++frame) {
    Simulation resumed(input);
    resumed.restore(whole.state());
    advance(whole, 1);
    advance(resumed, 1);
    EXPECT_EQ(state_hash(resumed.state()), state_hash(whole.state())) << "frame " << frame;
  }
}

}  // namespace
}  // namespace drape
