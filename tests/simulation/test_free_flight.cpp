#include <gtest/gtest.h>

#include <cmath>

#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

TEST(FreeFlight, FallsAsGravitySaysToRounding) {
  SimulationInput input = simulate_alone(sheet(1, 12, 0));
  remove_air(input);
  Simulation simulation(input);
  const double h = input.frame_duration / simulation.steps_per_frame();
  advance(simulation, 30);
  // Symplectic Euler: after n steps the way is g h2 n (n + 1) / 2.
  const double n = 30 * simulation.steps_per_frame();
  const double way = -9.81 * h * h * n * (n + 1) / 2;
  for (std::size_t v = 0; v < simulation.state().positions.size(); ++v) {
    const Vec3 moved = simulation.state().positions[v] - input.cloths[0].start_positions[v];
    EXPECT_NEAR(moved.y(), way, 1e-10);
    EXPECT_NEAR(Vec2(moved.x(), moved.z()).norm(), 0, 1e-10);
    EXPECT_NEAR(simulation.state().velocities[v].y(), -9.81 * n * h, 1e-9);
  }
}

Simulation tumbling_sheet() {
  SimulationInput input = simulate_alone(sheet(1, 16, 0));
  remove_air(input);
  input.gravity.setZero();
  Simulation simulation(input);
  State state = simulation.state();
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    const Vec3& p = state.positions[v];
    state.velocities[v] = Vec3(0.3, 0.1, -0.2) + Vec3(1, 2, 0.5).cross(p) + Vec3(0, std::sin(7 * p.x()), 0);
  }
  simulation.restore(state);
  return simulation;
}

TEST(FreeFlight, KeepsLinearMomentum) {
  Simulation simulation = tumbling_sheet();
  const Vec3 before = linear_momentum(simulation);
  advance(simulation, 60);
  EXPECT_LT((linear_momentum(simulation) - before).norm(), 1e-9 * before.norm());
}

TEST(FreeFlight, KeepsAngularMomentum) {
  Simulation simulation = tumbling_sheet();
  const Vec3 before = angular_momentum(simulation);
  advance(simulation, 60);
  EXPECT_LT((angular_momentum(simulation) - before).norm(), 1e-9 * before.norm());
}

TEST(FreeFlight, NeverGainsEnergy) {
  Simulation simulation = tumbling_sheet();
  double before = 1e300;
  for (int frame = 0; frame < 90; ++frame) {
    const double energy = simulation.advance_frame().kinetic_energy;
    // Stretch and bending give back a little of what they hold.
    EXPECT_LT(energy, before * 1.02);
    before = energy;
  }
}

TEST(FreeFlight, OnePieceDoesNotPullAnother) {
  SimulationInput input;
  remove_air(input);
  input.gravity.setZero();
  input.cloths = {sheet(1, 8, 0), sheet(1, 8, 1)};
  Simulation simulation(input);
  State state = simulation.state();
  for (std::size_t v = 0; v < 64; ++v) state.velocities[v] = Vec3(1, 0, 0);
  simulation.restore(state);
  advance(simulation, 10);
  for (std::size_t v = 64; v < 128; ++v) EXPECT_LT(simulation.state().velocities[v].norm(), 1e-10);
}

}  // namespace
}  // namespace drape
