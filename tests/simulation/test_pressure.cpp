#include <gtest/gtest.h>

#include <algorithm>

#include "simulation/pressure.h"
#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

SimulationInput balloon(double pressure) {
  SimulationInput input = simulate_alone(ball(0.3, 32));
  input.gravity.setZero();
  input.cloths[0].pressure = pressure;
  input.cloths[0].material.elastic.stretch_stiffness = {2000, 2000};
  return input;
}

double mean_radius(const State& state) {
  double sum = 0;
  for (const Vec3& p : state.positions) sum += p.norm();
  return sum / static_cast<double>(state.positions.size());
}

// A membrane whose tension is k e at a strain e holds p = 2 k e / R, and R = R0 (1 + e).
double membrane_radius(double pressure, double stiffness, double radius) {
  return radius / (1 - pressure * radius / (2 * stiffness));
}

TEST(Pressure, BlowsABalloonUpAsFarAsItsMembraneHolds) {
  for (const double pressure : {100.0, 300.0}) {
    Simulation simulation(balloon(pressure));
    const FrameStatistics statistics = advance(simulation, 60);
    const double growth = mean_radius(simulation.state()) - 0.3;
    const double expected = membrane_radius(pressure, 2000, 0.3) - 0.3;
    EXPECT_NEAR(growth, expected, 0.2 * expected) << pressure << " Pa";
    EXPECT_LT(statistics.largest_speed, 0.02) << pressure << " Pa";
  }
}

TEST(Pressure, PushesOutwardWhicheverWayTheTrianglesTurn) {
  SimulationInput input = balloon(300);
  for (Triangle& triangle : input.cloths[0].mesh.triangles) std::swap(triangle[0], triangle[1]);
  const std::vector<double> pressures = triangle_pressures(input.cloths);
  EXPECT_EQ(std::count(pressures.begin(), pressures.end(), -300.0), std::ssize(pressures));
}

TEST(Pressure, OfAClosedClothPushesItNowhere) {
  SimulationInput input = balloon(1000);
  remove_air(input);
  for (Vec3& p : input.cloths[0].start_positions) p = Vec3(1.3 * p.x(), p.y() + 0.1 * p.x(), 0.8 * p.z());
  Simulation simulation(input);
  advance(simulation, 10);
  EXPECT_LT(linear_momentum(simulation).norm(), 1e-10);
}

TEST(Pressure, CostsNothingWhereNoClothHasAny) {
  EXPECT_TRUE(triangle_pressures({sheet(1, 3, 0), ball(1, 8)}).empty());
}

}  // namespace
}  // namespace drape
