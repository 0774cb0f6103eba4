#include <gtest/gtest.h>

#include <cmath>

#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

// Points are floats from where each step starts: a part in 1e7 of the way of a step, at random.
TEST(FreeFlight, FallsAsGravitySays) {
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
    EXPECT_NEAR(moved.y(), way, 1e-6);
    EXPECT_NEAR(Vec2(moved.x(), moved.z()).norm(), 0, 1e-6);
    EXPECT_NEAR(simulation.state().velocities[v].y(), -9.81 * n * h, 1e-4);
  }
}

TEST(FreeFlight, TheCentreOfMassFallsToRounding) {
  SimulationInput input = simulate_alone(sheet(1, 12, 0));
  remove_air(input);
  Simulation simulation(input);
  advance(simulation, 30);
  const double steps = 30 * simulation.steps_per_frame(),
               h = input.frame_duration / simulation.steps_per_frame();
  const double mass = linear_momentum(simulation).y() / (-9.81 * steps * h);
  EXPECT_NEAR(mass, 0.2, 1e-12);
  double centre = 0;
  const std::vector<double> masses = point_masses(simulation);
  for (std::size_t v = 0; v < masses.size(); ++v)
    centre += masses[v] * simulation.state().positions[v].y() / mass;
  EXPECT_NEAR(centre, -9.81 * h * h * steps * (steps + 1) / 2, 1e-12);
}

Simulation tumbling_sheet(int points = 16, double step = 0.002, double strain_limit = 0) {
  SimulationInput input = simulate_alone(sheet(1, points, 0));
  input.cloths[0].material.elastic.strain_limit = strain_limit;
  input.frame_duration = input.largest_step = step;
  input.self_collision = false;  // friction acts across the thickness, and so turns
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

TEST(FreeFlight, KeepsLinearMomentumForTenSeconds) {
  Simulation simulation = tumbling_sheet();
  const Vec3 before = linear_momentum(simulation);
  advance(simulation, 5000);
  EXPECT_LT((linear_momentum(simulation) - before).norm(), 1e-9 * before.norm());
}

// But for what limits on strain do: they move points while these go on, and the sheet turns a little.
TEST(FreeFlight, KeepsAngularMomentumForTenSeconds) {
  constexpr double out_of_reach = 0.5;
  Simulation simulation = tumbling_sheet(16, 0.002, out_of_reach);
  const Vec3 before = angular_momentum(simulation);
  advance(simulation, 5000);
  EXPECT_LT((angular_momentum(simulation) - before).norm(), 1e-9 * before.norm());
}

// All its energy is of motion at the start; what stretch and bending hold in between they give back, but no
// more.
TEST(FreeFlight, GainsNoEnergyInAMinuteWhateverTheStep) {
  for (const double step : {0.001, 0.002, 0.005}) {
    Simulation simulation = tumbling_sheet(8, step);
    double most = 0;
    const double start = simulation.advance_frame().kinetic_energy;
    for (int frame = 0; frame < 60 / step; ++frame)
      most = std::max(most, simulation.advance_frame().kinetic_energy);
    EXPECT_LE(most, start) << step;
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
  for (std::size_t v = 64; v < 128; ++v) EXPECT_LT(simulation.state().velocities[v].norm(), 1e-4);
}

TEST(FreeFlight, AThrownSheetGoesWhereItWasThrown) {
  SimulationInput input = simulate_alone(sheet(0.3, 8, 1));
  remove_air(input);
  input.cloths[0].start_velocity = Vec3(3, 2, -1);
  Simulation simulation(input);
  const std::vector<Vec3> start = simulation.state().positions;
  advance(simulation, 6);
  const double time = 6 * input.frame_duration, step = input.frame_duration / simulation.steps_per_frame();
  const Vec3 fall = 0.5 * input.gravity * time * (time + step);  // as steps sum it up
  for (std::size_t v = 0; v < start.size(); ++v)
    EXPECT_LT((simulation.state().positions[v] - start[v] - time * Vec3(3, 2, -1) - fall).norm(), 1e-6);
}

}  // namespace
}  // namespace drape
