#include <gtest/gtest.h>

#include <algorithm>

#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

// Falls 5 mm, and lies still well within a second.
SimulationInput sheet_on_the_ground() {
  SimulationInput input = simulate_alone(sheet(0.3, 9, 0.01));
  input.colliders.push_back(ground());
  return input;
}

ColliderInput ball_at(const Vec3& place) {
  ColliderInput ball{"ball", SphereShape{0.1}, {}, 0.3};
  ball.motion.at = place;
  return ball;
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
}

TEST(Rest, EndsWhenAColliderComes) {
  SimulationInput input = sheet_on_the_ground();
  ColliderInput plough = ball_at({-0.5, 0.1, 0});
  plough.motion.translate[0] = {{2.0, 0.0}, {3.0, 1.0}};
  input.colliders.push_back(plough);
  Simulation simulation(input);
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
  advance(simulation, 74);
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
  SimulationInput input = simulate_alone(sheet(0.3, 9, 1));
  PinInput all{};
  for (int v = 0; v < 81; ++v) all.vertices.push_back(v);
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

// It starts as still as can be, and out of balance by a hundredth of a millimetre a metre.
TEST(Rest, ASheetThatStandsOnItsEdgeFalls) {
  SimulationInput input = simulate_alone(standing_sheet(0.5, 17, 0.005));
  input.colliders.push_back(ground());
  for (Vec3& point : input.cloths[0].start_positions) point.z() += 1e-5 * point.y();
  Simulation simulation(input);
  advance(simulation, 60);
  double highest = 0;
  for (const Vec3& point : simulation.state().positions) highest = std::max(highest, point.y());
  EXPECT_LT(highest, 0.25);
}

TEST(Rest, ResumedAnywhereItGivesTheSameBits) {
  SimulationInput input = sheet_on_the_ground();
  ColliderInput plough = ball_at({-0.5, 0.1, 0});
  plough.motion.translate[0] = {{2.0, 0.0}, {3.0, 1.0}};
  input.colliders.push_back(plough);
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
