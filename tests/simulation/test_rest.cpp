#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/primitives.h"
#include "simulation/rest.h"
#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

SimulationInput that_may_sleep(ClothInput cloth) {
  SimulationInput input = simulate_alone(std::move(cloth));
  input.sleep = true;
  return input;
}

// Falls 5 mm, and lies still well within a second.
SimulationInput sheet_on_the_ground() {
  SimulationInput input = that_may_sleep(sheet(0.3, 9, 0.01));
  input.colliders.push_back(ground());
  return input;
}

PinInput pin_all(const ClothInput& cloth) {
  PinInput pin{};
  for (int v = 0; v < static_cast<int>(cloth.mesh.positions.size()); ++v) pin.vertices.push_back(v);
  return pin;
}

ColliderInput ball_at(const Vec3& place) {
  ColliderInput ball{"ball", SphereShape{0.1}, {}, 0.3};
  ball.motion.at = place;
  return ball;
}

// It comes after two seconds.
SimulationInput with_a_plough() {
  SimulationInput input = sheet_on_the_ground();
  ColliderInput plough = ball_at({-0.5, 0.1, 0});
  plough.motion.translate[0] = {{2.0, 0.0}, {3.0, 1.0}};
  input.colliders.push_back(plough);
  return input;
}

double cpu_seconds(const FrameStatistics& statistics) {
  double sum = 0;
  for (const double seconds : statistics.profile.cpu_seconds) sum += seconds;
  return sum;
}

// Whether the next frame takes no step.
bool sleeps(Simulation& simulation) { return cpu_seconds(simulation.advance_frame()) == 0; }

bool sleeps_at(double seconds, const SimulationInput& input) {
  Simulation simulation(input);
  advance(simulation, static_cast<int>(seconds / input.frame_duration));
  return sleeps(simulation);
}

TEST(Rest, ClothThatLiesStillIsLeftWhereItIs) {
  Simulation simulation(sheet_on_the_ground());
  EXPECT_FALSE(sleeps(simulation));
  advance(simulation, 45);
  const State before = simulation.state();
  const FrameStatistics statistics = simulation.advance_frame();
  EXPECT_EQ(cpu_seconds(statistics), 0);
  EXPECT_EQ(statistics.kinetic_energy, 0);
  EXPECT_EQ(statistics.contacts, before.contacts);
  EXPECT_GT(statistics.contacts, 0);
  EXPECT_EQ(simulation.state().positions, before.positions);
  EXPECT_EQ(simulation.state().frame, before.frame + 1);
}

TEST(Rest, NotBeforeHalfASecondHasGoneBy) {
  Simulation simulation(sheet_on_the_ground());
  int frames = 1;
  for (; !sleeps(simulation) && frames < 100; ++frames) {
  }
  EXPECT_GT(frames, 15);
  EXPECT_LT(frames, 45);
}

TEST(Rest, IsNoneWhereTheInputWantsNone) {
  SimulationInput input = sheet_on_the_ground();
  EXPECT_TRUE(sleeps_at(2, input));
  input.sleep = false;
  EXPECT_FALSE(sleeps_at(2, input));
}

TEST(Rest, IsNoneInGusts) {
  SimulationInput input = sheet_on_the_ground();
  input.wind.velocity = Vec3(0.01, 0, 0);  // steady, it moves nothing here
  EXPECT_TRUE(sleeps_at(2, input));
  input.wind.gust = 0.5;
  EXPECT_FALSE(sleeps_at(2, input));
  remove_air(input);  // it takes hold of nothing
  EXPECT_TRUE(sleeps_at(2, input));
}

TEST(Rest, EndsWhenAColliderComes) {
  Simulation simulation(with_a_plough());
  advance(simulation, 59);
  EXPECT_TRUE(sleeps(simulation));
  EXPECT_FALSE(sleeps(simulation));  // from its key on, though it is not there yet
  const Vec3 at_rest = simulation.state().positions[40];
  advance(simulation, 20);
  EXPECT_GT((simulation.state().positions[40] - at_rest).norm(), 0.01);
}

// A frame's two ends are alike, and what is between them is not.
TEST(Rest, EndsWhenAColliderComesAndGoesInOneFrame) {
  SimulationInput input = sheet_on_the_ground();
  const double frame = input.frame_duration;
  ColliderInput ball = ball_at({0, 1, 0});
  ball.motion.translate[0] = {{60 * frame, 0.0}, {60.5 * frame, 0.1}, {61 * frame, 0.0}};
  input.colliders.push_back(ball);
  Simulation simulation(input);
  advance(simulation, 59);
  EXPECT_TRUE(sleeps(simulation));
  EXPECT_FALSE(sleeps(simulation));
}

TEST(Rest, CountsAnewFromWhatStirred) {
  SimulationInput input = sheet_on_the_ground();
  ColliderInput far_away = ball_at({0, 5, 0});
  far_away.motion.translate[0] = {{0.0, 0.0}, {2.0, 0.1}};
  input.colliders.push_back(far_away);
  Simulation simulation(input);
  advance(simulation, 60 + 14);
  EXPECT_FALSE(sleeps(simulation));
  EXPECT_TRUE(sleeps(simulation));
}

TEST(Rest, EndsWhenAShapeChanges) {
  SimulationInput input = sheet_on_the_ground();
  MeshShape table{{{{-0.2, 0, -0.2}, {0.2, 0, -0.2}, {0, 0, 0.3}}, {{0, 2, 1}}, {}, {}}, {}, 2.0, 0.1};
  table.shapes = {table.mesh.positions, table.mesh.positions};
  for (Vec3& point : table.shapes[1]) point.y() += 0.05;
  input.colliders.push_back({"table", table, {}, 0.3});
  input.colliders.back().motion.at = Vec3(0, 1, 0);
  Simulation simulation(input);
  advance(simulation, 59);
  EXPECT_TRUE(sleeps(simulation));
  for (int frame = 0; frame < 3; ++frame) EXPECT_FALSE(sleeps(simulation));
  advance(simulation, 15);
  EXPECT_TRUE(sleeps(simulation));
}

TEST(Rest, EndsWhenPinsLetGo) {
  SimulationInput input = that_may_sleep(sheet(0.3, 9, 1));
  PinInput all = pin_all(input.cloths[0]);
  all.until = 60 * input.frame_duration;
  input.cloths[0].pins.push_back(all);
  Simulation simulation(input);
  advance(simulation, 59);
  EXPECT_TRUE(sleeps(simulation));
  EXPECT_FALSE(sleeps(simulation));
  advance(simulation, 10);
  EXPECT_LT(lowest_point(simulation), 0.9);
}

TEST(Rest, EndsWhenPinsTakeHoldAndMove) {
  SimulationInput input = sheet_on_the_ground();
  RigidMotion lift;
  lift.translate[1] = {{2.5, 0.0}, {3.0, 0.2}};
  input.cloths[0].pins.push_back({{0}, lift, {}, 60 * input.frame_duration});
  Simulation simulation(input);
  advance(simulation, 59);
  EXPECT_TRUE(sleeps(simulation));
  EXPECT_FALSE(sleeps(simulation));  // they take hold
  advance(simulation, 29);
  EXPECT_NEAR(simulation.state().positions[0].y(), 0.2, 0.01);
}

TEST(Rest, EndsWhenASeamIsDrawnIn) {
  SimulationInput input = sheet_on_the_ground();
  input.cloths.push_back(sheet(0.3, 9, 0.01));
  for (Vec3& point : input.cloths[1].start_positions) point.z() += 0.35;
  SeamInput seam{};
  seam.cloths = {0, 1};
  seam.vertices = {std::vector<int>{76}, std::vector<int>{4}};
  seam.from = 60 * input.frame_duration;
  seam.close = 90 * input.frame_duration;
  input.seams.push_back(seam);
  Simulation simulation(input);
  const auto gap = [&] {
    return (simulation.state().positions[76] - simulation.state().positions[81 + 4]).norm();
  };
  advance(simulation, 59);
  EXPECT_TRUE(sleeps(simulation));
  EXPECT_GT(gap(), 0.04);
  advance(simulation, 32);
  EXPECT_LT(gap(), 0.01);
}

// A hand takes a vertex over from another: what is held does not change, and what it is held by does.
TEST(Rest, EndsWhenOnePinTakesOverFromAnother) {
  SimulationInput input = that_may_sleep(sheet(0.3, 9, 1));
  for (Vec3& point : input.cloths[0].start_positions) point.x() += 2;
  const double frame = input.frame_duration;
  PinInput first = pin_all(input.cloths[0]), second = first;
  first.until = second.from = 60 * frame;
  second.motion.emplace();
  second.motion->translate[1] = {{100 * frame, 0.0}, {130 * frame, 0.3}};
  input.cloths[0].pins = {first, second};
  Simulation simulation(input);
  advance(simulation, 59);
  EXPECT_TRUE(sleeps(simulation));
  EXPECT_FALSE(sleeps(simulation));
  advance(simulation, 27);
  EXPECT_TRUE(sleeps(simulation));
  const FrameStatistics statistics = advance(simulation, 42);
  EXPECT_LT(statistics.largest_pin_lag, 1e-9);
  EXPECT_LT((simulation.state().positions[0] - input.cloths[0].start_positions[0] - Vec3(0, 0.3, 0)).norm(),
            1e-9);
}

TEST(Rest, IsNoneWhileAColliderIsHeldUp) {
  SimulationInput input = that_may_sleep(sheet(0.3, 9, 0));
  input.cloths[0].pins.push_back(pin_all(input.cloths[0]));
  ColliderInput press = ball_at({0, 0.2, 0});
  press.motion.translate[1] = {{0.0, 0.0}, {1.0, -0.4}};
  input.colliders.push_back(press);
  EXPECT_FALSE(sleeps_at(3, input));
  input.colliders[0].motion.translate[1].back().second = -0.05;  // it comes nowhere near
  EXPECT_TRUE(sleeps_at(3, input));
}

TEST(Rest, TakesNineFramesHoweverLongTheyAre) {
  SimulationInput input = sheet_on_the_ground();
  input.frame_duration = 1;
  EXPECT_FALSE(sleeps_at(9, input));
  EXPECT_TRUE(sleeps_at(11, input));
}

double height(const Simulation& simulation) {
  double highest = 0;
  for (const Vec3& point : simulation.state().positions) highest = std::max(highest, point.y());
  return highest;
}

// It starts as still as can be, and out of balance by a hundredth of a millimetre a metre.
TEST(Rest, ALimpSheetThatStandsOnItsEdgeFalls) {
  SimulationInput input = that_may_sleep(standing_sheet(0.5, 17, 0.005));
  input.colliders.push_back(ground());
  for (Vec3& point : input.cloths[0].start_positions) point.z() += 1e-5 * point.y();
  Simulation simulation(input);
  advance(simulation, 60);
  EXPECT_LT(height(simulation), 0.25);
}

// As slowly as a board: within half a second it hardly moves.
TEST(Rest, AStiffSheetThatStandsOnItsEdgeFalls) {
  SimulationInput input = that_may_sleep(standing_sheet(0.5, 9, 0.005));
  input.cloths[0].material.elastic.bend_stiffness = {0.05, 0.05};
  input.colliders.push_back(ground());
  for (Vec3& point : input.cloths[0].start_positions) point.z() += 2e-5 * point.y();
  Simulation simulation(input);
  advance(simulation, 40);
  EXPECT_GT(height(simulation), 0.5);
  advance(simulation, 110);
  EXPECT_LT(height(simulation), 0.1);
}

TEST(Rest, ClothThatNothingHoldsFallsAndFloats) {
  SimulationInput input = that_may_sleep(sheet(1, 9, 1));
  remove_air(input);
  input.gravity = Vec3(0, -0.001, 0);
  EXPECT_FALSE(sleeps_at(2, input));
  input.gravity.setZero();
  input.cloths[0].start_velocity = Vec3(0.0005, 0, 0);
  Simulation simulation(input);
  advance(simulation, 90);
  EXPECT_NEAR(simulation.state().positions[0].x() - input.cloths[0].start_positions[0].x(), 0.0015, 1e-6);
}

Sheet two_grids(double first_edge, double second_edge) {
  Sheet sheet;
  for (const double edge : {first_edge, second_edge}) {
    const TriangleMesh grid = make_grid({edge, edge}, {2, 2});
    const int first = static_cast<int>(sheet.rest_positions.size());
    sheet.rest_positions.insert(sheet.rest_positions.end(), grid.positions.begin(), grid.positions.end());
    for (const auto& [a, b, c] : grid.triangles) sheet.triangles.push_back({a + first, b + first, c + first});
    sheet.triangle_materials.resize(sheet.triangles.size(), static_cast<int>(sheet.materials.size()));
    sheet.materials.push_back({});
  }
  sheet.topology = build_topology(static_cast<int>(sheet.rest_positions.size()), sheet.triangles);
  return sheet;
}

// A square's diagonal is its fifth edge.
TEST(Rest, StillIsAFiftiethOfTheShortestClothsMeanEdgeAndHalfAMillimetreAtMost) {
  const double mean = (4 + std::sqrt(2.0)) / 5;
  EXPECT_NEAR(largest_still_way(two_grids(0.01, 0.3)), 0.02 * 0.01 * mean, 1e-12);
  EXPECT_NEAR(largest_still_way(two_grids(0.3, 0.01)), 0.02 * 0.01 * mean, 1e-12);
  EXPECT_EQ(largest_still_way(two_grids(0.3, 0.3)), 0.0005);
}

TEST(Rest, ResumedAnywhereItGivesTheSameBits) {
  const SimulationInput input = with_a_plough();
  Simulation whole(input);
  std::vector<State> states;
  for (int frame = 0; frame < 75; ++frame) {
    whole.advance_frame();
    states.push_back(whole.state());
  }
  for (const std::size_t stop : {7, 20, 40, 65}) {
    Simulation resumed(input);
    resumed.restore(states[stop]);
    advance(resumed, 74 - static_cast<int>(stop));
    EXPECT_EQ(state_hash(resumed.state()), state_hash(whole.state())) << "stopped at " << stop + 1;
  }
}

}  // namespace
}  // namespace drape
