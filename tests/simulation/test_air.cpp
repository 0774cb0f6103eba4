#include <gtest/gtest.h>

#include <cmath>

#include "simulation/forces.h"
#include "simulation/plate_in_air.h"
#include "simulation/scenarios.h"
#include "simulation/wind.h"

namespace drape {
namespace {

using namespace test;

constexpr double air_density = 1.2;

Vec3 sum_of_forces(const World& world, const State& state) {
  std::vector<Vec3> accelerations;
  std::vector<Vec3> air_forces;
  feel_air(world, 0, state.positions, state.velocities, air_forces);
  external_accelerations(world, air_forces, state.positions, accelerations);
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < accelerations.size(); ++v) sum += world.masses[v] * accelerations[v];
  return sum;
}

// The force of a weak wind along +x on a square metre whose normal is turned by `degrees` from +x to +y.
Vec3 force_on_plate(double degrees, const WindInput& wind) {
  ClothInput cloth = sheet(1, 5, 0);
  const auto [s, c] = sin_cos_degrees(degrees);
  for (Vec3& p : cloth.start_positions) p = Vec3(-s * p.x(), c * p.x(), p.z());
  SimulationInput input = simulate_alone(cloth);
  input.gravity.setZero();
  input.wind = wind;
  input.largest_step = 1e-5;  // so short that the cut of a whole step's force does not show
  const World world = build_world(input);
  return sum_of_forces(world, initial_state(world));
}

WindInput weak_wind() {
  WindInput wind;
  wind.velocity = Vec3(1, 0, 0);
  return wind;
}

TEST(Air, PressesOnABroadsidePlateAsItsDragSays) {
  const Vec3 force = force_on_plate(0, weak_wind());
  EXPECT_NEAR(force.x(), 0.5 * air_density * WindInput().drag, 1e-4);
  EXPECT_NEAR(force.y(), 0, 1e-12);
}

TEST(Air, DragsAnEdgeOnPlateAsItsSkinFrictionSays) {
  const Vec3 force = force_on_plate(90, weak_wind());
  EXPECT_NEAR(force.x(), 0.5 * air_density * WindInput().tangential_drag, 1e-6);
  EXPECT_NEAR(force.y(), 0, 1e-12);
}

TEST(Air, DeflectsATiltedPlateSideways) {
  const WindInput wind = weak_wind();
  const Vec3 force = force_on_plate(30, wind);  // sine and cosine of the angle to the plane: cos 30, sin 30
  const double across = std::sqrt(0.75), along = 0.5;
  const double lift = (wind.drag + wind.lift - wind.tangential_drag) * across * along;
  const double drag = wind.drag * across * across + wind.tangential_drag * along * along;
  EXPECT_NEAR(force.y(), 0.5 * air_density * lift, 1e-4);
  EXPECT_NEAR(force.x(), 0.5 * air_density * drag, 1e-4);
}

TEST(Air, LetsASheetFallAtItsTerminalVelocity) {
  SimulationInput input = simulate_alone(sheet(1, 10, 0));
  input.wind.lift = 0;  // which makes it glide
  Simulation simulation(input);
  advance(simulation, 60);
  const double terminal = std::sqrt(2 * 0.2 * 9.81 / (air_density * input.wind.drag));
  for (const Vec3& velocity : simulation.state().velocities)
    EXPECT_NEAR(velocity.y(), -terminal, 0.02 * terminal);
}

TEST(Air, NeverAddsRelativeMotion) {
  for (const double coefficient : {1.0, 100.0}) {
    SimulationInput input = simulate_alone(sheet(0.2, 12, 0));
    input.gravity.setZero();
    input.largest_step = 0.005;
    input.wind = {Vec3(30, -5, 8), 0, 2, 0, coefficient, 0.1 * coefficient, coefficient};
    const World world = build_world(input);
    State state = initial_state(world);
    const auto crumple = [](std::size_t v) { return std::sin(12.9898 * static_cast<double>(v)); };
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
      state.positions[v] += 0.01 * Vec3(crumple(v), crumple(v + 1000), crumple(v + 2000));
      state.velocities[v] = 20 * Vec3(crumple(v + 3000), crumple(v + 4000), crumple(v + 5000));
    }
    std::vector<Vec3> accelerations;
    double before = 1e300;
    for (int i = 0; i < 20; ++i) {
      double relative = 0;
      for (std::size_t v = 0; v < state.positions.size(); ++v)
        relative += world.masses[v] * (state.velocities[v] - input.wind.velocity).squaredNorm();
      EXPECT_LT(relative, before) << "coefficient " << coefficient << ", step " << i;
      before = relative;
      std::vector<Vec3> air_forces;
      feel_air(world, 0, state.positions, state.velocities, air_forces);
      external_accelerations(world, air_forces, state.positions, accelerations);
      for (std::size_t v = 0; v < state.positions.size(); ++v)
        state.velocities[v] += world.steps_per_air * world.step * accelerations[v];
    }
  }
}

LaneVec3<double> as_lane(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

// Of one triangle by itself, at the start.
Vec3 slow_force(const World& world, std::size_t t, const State& state) {
  const auto& [a, b, c] = world.sheet.triangles[t];
  const std::vector<Vec3>&x = state.positions, &v = state.velocities;
  const Vec3 wind = wind_at(world.input.wind, (x[a] + x[b] + x[c]) / 3, 0);
  const LaneVec3<double> stream = as_lane(wind - (v[a] + v[b] + v[c]) / 3);
  const LaneVec3<double> area = as_lane(0.5 * (x[b] - x[a]).cross(x[c] - x[a]));
  const LaneVec3<double> force = lasting_force(force_of_air(world.input.wind, stream, area), stream,
                                               world.triangle_masses[t], world.steps_per_air * world.step);
  return {force.x, force.y, force.z};
}

// Eight triangles, and two over; one is collapsed, and one flies with the wind.
TEST(Air, FourTrianglesAtATimeGiveTheBitsOfEachByItself) {
  SimulationInput input = simulate_alone(sheet(0.2, 3, 0));
  input.wind = {Vec3(3, -5, 8), 0, 2, 0, 1.1, 0.1, 0.7};
  input.cloths.push_back(sheet(0.3, 2, 1));
  const World world = build_world(input);
  ASSERT_NE(world.sheet.triangles.size() % 4, 0);
  State state = initial_state(world);
  for (std::size_t v = 0; v < state.positions.size(); ++v)
    state.velocities[v] = 4 * Vec3(std::sin(v), std::cos(5 * v), std::sin(7 * v));
  for (const int v : world.sheet.triangles[0]) state.velocities[v] = input.wind.velocity;
  const auto& [a, b, c] = world.sheet.triangles[1];
  state.positions[c] = 0.5 * (state.positions[a] + state.positions[b]);
  std::vector<Vec3> forces;
  feel_air(world, 0, state.positions, state.velocities, forces);
  for (std::size_t t = 0; t < forces.size(); ++t) EXPECT_EQ(forces[t], slow_force(world, t, state)) << t;
  EXPECT_EQ(forces[0], Vec3(Vec3::Zero()));
  EXPECT_EQ(forces[1], Vec3(Vec3::Zero()));
  EXPECT_NE(forces[2], Vec3(Vec3::Zero()));
}

TEST(Air, FourTrianglesAtATimeFeelTheGustsOfEach) {
  SimulationInput input = simulate_alone(sheet(0.2, 3, 0));
  input.wind.velocity = Vec3(3, -5, 8);
  input.wind.gust = 0.5;
  input.wind.gust_size = 0.3;
  const World world = build_world(input);
  const State state = initial_state(world);
  std::vector<Vec3> forces;
  feel_air(world, 0, state.positions, state.velocities, forces);
  for (std::size_t t = 0; t < forces.size(); ++t) EXPECT_EQ(forces[t], slow_force(world, t, state)) << t;
  EXPECT_GT((forces[0] - forces[2]).norm(), 0.01 * forces[0].norm());
}

TEST(Air, LeavesPinnedPointsAndAVacuumAlone) {
  SimulationInput input = simulate_alone(sheet(1, 4, 0));
  input.wind.velocity = Vec3(0, 5, 0);
  input.cloths[0].pins.push_back({{3}, {}, {}});
  remove_air(input);
  const World world = build_world(input);
  const State state = initial_state(world);
  std::vector<Vec3> accelerations;
  std::vector<Vec3> air_forces;
  feel_air(world, 0, state.positions, state.velocities, air_forces);
  external_accelerations(world, air_forces, state.positions, accelerations);
  for (int v = 0; v < 16; ++v)
    EXPECT_EQ(accelerations[v], v == 3 ? Vec3(Vec3::Zero()) : Vec3(0, -9.81, 0)) << v;
}

WindInput gusty(int seed) {
  WindInput wind;
  wind.velocity = Vec3(6, 0, 0);
  wind.gust = 0.5;
  wind.seed = seed;
  return wind;
}

TEST(Gusts, RepeatWithTheirSeedAndDifferWithAnother) {
  const Vec3 place(0.3, 1.7, -2.2);
  EXPECT_EQ(wind_at(gusty(1), place, 2.5), wind_at(gusty(1), place, 2.5));
  EXPECT_GT((wind_at(gusty(1), place, 2.5) - wind_at(gusty(2), place, 2.5)).norm(), 0.01);
  EXPECT_EQ(wind_at(WindInput{Vec3(6, 0, 0)}, place, 2.5), Vec3(6, 0, 0));
}

TEST(Gusts, StayWithinTheirStrengthRoundTheirMean) {
  Vec3 sum = Vec3::Zero();
  double largest = 0;
  const int count = 20000;
  for (int i = 0; i < count; ++i) {
    const Vec3 gust = wind_at(gusty(1), Vec3(0, 1, 2), 0.05 * i) - Vec3(6, 0, 0);
    largest = std::max(largest, gust.cwiseAbs().maxCoeff());
    sum += gust;
  }
  EXPECT_LE(largest, 3);
  EXPECT_GT(largest, 1.5);
  EXPECT_LT((sum / count).norm(), 0.1);
}

TEST(Gusts, AreSmoothInTimeAndPlace) {
  const WindInput wind = gusty(1);
  for (int i = 0; i < 5000; ++i) {
    const double time = 0.01 * i;
    const Vec3 here = wind_at(wind, Vec3::Zero(), time);
    EXPECT_LT((wind_at(wind, Vec3::Zero(), time + 1e-4) - here).norm(), 0.02);
    EXPECT_LT((wind_at(wind, Vec3(0, 1e-4, 0), time) - here).norm(), 0.005);
  }
}

// The mean wind carries them along.
TEST(Gusts, ArriveLaterDownwind) {
  const WindInput wind = gusty(1);
  EXPECT_LT((wind_at(wind, Vec3(3, 0, 0), 1.5) - wind_at(wind, Vec3::Zero(), 1)).norm(), 1e-9);
}

}  // namespace
}  // namespace drape
