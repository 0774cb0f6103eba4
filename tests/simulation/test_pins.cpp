#include <gtest/gtest.h>

#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

SimulationInput falling_sheet() { return simulate_alone(sheet(0.5, 8, 1)); }

ColliderInput turning_ball() {
  ColliderInput ball{"hand", SphereShape{0.05}, {}, 0.3};
  ball.motion.at = Vec3(0, 3, 0);
  ball.motion.turn[1] = {{0.0, 0.0}, {1.0, 90.0}};
  ball.motion.translate[0] = {{0.0, 0.0}, {1.0, 0.5}};
  return ball;
}

TEST(Pins, FollowASphereThatTurnsAndMoves) {
  SimulationInput input = falling_sheet();
  input.colliders.push_back(turning_ball());
  input.cloths[0].pins.push_back({{0, 7}, {}, {}, 0, 0});
  Simulation simulation(input);
  for (int frame = 1; frame <= 30; ++frame) {
    simulation.advance_frame();
    const RigidPose start = pose_at(turning_ball().motion, 0);
    const RigidPose now = simulation.state().collider_poses[0];
    for (const int v : {0, 7}) {
      const Vec3 local =
          start.rotation.transpose() * (input.cloths[0].start_positions[v] - start.translation);
      EXPECT_LT((simulation.state().positions[v] - now(local)).norm(), 1e-12) << "frame " << frame;
    }
  }
  // A quarter turn about +y brings -x -z to -x +z; the sphere has gone 0.5 m along x.
  EXPECT_LT((simulation.state().positions[0] - Vec3(0.25, 1, 0.25)).norm(), 1e-9);
}

TEST(Pins, GrabVerticesWhereTheyAreThen) {
  SimulationInput input = falling_sheet();
  RigidMotion lift;
  lift.translate[1] = {{0.0, 0.0}, {1.0, 1.0}};  // half of it is over at the grab
  input.cloths[0].pins.push_back({{0}, lift, {}, 15 * input.frame_duration});
  Simulation simulation(input);
  advance(simulation, 15);
  const Vec3 grabbed = simulation.state().positions[0];
  EXPECT_LT(grabbed.y(), 0.9);  // it fell until then
  advance(simulation, 15);
  EXPECT_LT((simulation.state().positions[0] - grabbed - Vec3(0, 0.5, 0)).norm(), 1e-9);
}

// What it does not hold yet it cannot be late with, wherever the cloth is.
TEST(Pins, ThatGrabLaterHaveNoLag) {
  SimulationInput input = falling_sheet();
  input.colliders.push_back(turning_ball());
  const double from = 5 * input.frame_duration;
  input.cloths[0].pins = {
      {{0}, {}, {}, from}, {{7}, turning_ball().motion, {}, from}, {{63}, {}, {}, from, 0}};
  Simulation simulation(input);
  for (int frame = 1; frame <= 10; ++frame)
    EXPECT_LT(simulation.advance_frame().largest_pin_lag, 1e-9) << "frame " << frame;
}

TEST(Pins, LetGoOfWhatTheyGrabbed) {
  SimulationInput input = falling_sheet();
  input.cloths[0].pins.push_back({{0}, {}, 10 * input.frame_duration, 5 * input.frame_duration});
  Simulation simulation(input);
  advance(simulation, 5);
  const Vec3 grabbed = simulation.state().positions[0];
  advance(simulation, 5);
  EXPECT_EQ(simulation.state().positions[0], grabbed);
  advance(simulation, 10);
  EXPECT_LT(simulation.state().positions[0].y(), grabbed.y() - 0.1);
}

// The grab is part of the state: a run that is resumed after it holds on to the same place.
TEST(Pins, KeepTheirGrabOverACheckpoint) {
  SimulationInput input = falling_sheet();
  input.colliders.push_back(turning_ball());
  input.cloths[0].pins.push_back({{0, 7}, {}, {}, 5 * input.frame_duration, 0});
  Simulation whole(input);
  for (int frame = 0; frame < 8; ++frame) {
    Simulation resumed(input);
    resumed.restore(whole.state());
    advance(whole, 1);
    advance(resumed, 1);
    EXPECT_EQ(state_hash(resumed.state()), state_hash(whole.state())) << "frame " << frame;
  }
}

TEST(Pins, HandOverFromOneToTheNext) {
  SimulationInput input = falling_sheet();
  RigidMotion lift;
  lift.translate[1] = {{0.0, 0.0}, {1.0, 1.0}};
  const double change = 10 * input.frame_duration;
  input.cloths[0].pins = {{{0}, {}, change}, {{0}, lift, {}, change}};
  Simulation simulation(input);
  advance(simulation, 25);
  EXPECT_NEAR(simulation.state().positions[0].y(), 1.5, 1e-9);
}

// Goes 0.15 m under the ground within half a second, and comes up again.
TEST(Pins, StopAtTheGroundAndCatchUpWhenTheyCan) {
  SimulationInput input = simulate_alone(sheet(0.3, 8, 0.1));
  input.colliders.push_back(ground());
  RigidMotion dive;
  dive.translate[1] = {{0.0, 0.0}, {0.5, -0.25}, {1.0, 0.0}};
  input.cloths[0].pins.push_back({{0, 1}, dive});
  Simulation simulation(input);
  double largest_lag = 0;
  FrameStatistics statistics;
  for (int frame = 1; frame <= 40; ++frame) {
    statistics = simulation.advance_frame();
    largest_lag = std::max(largest_lag, statistics.largest_pin_lag);
    EXPECT_GT(lowest_point(simulation), 0) << "frame " << frame;
    EXPECT_EQ(statistics.largest_lag, 0) << "the ground stays";
  }
  EXPECT_NEAR(largest_lag, 0.15, 0.01);
  EXPECT_LT(statistics.largest_pin_lag, 1e-9);
  EXPECT_NEAR(simulation.state().positions[0].y(), 0.1, 1e-9);
}

// The way of the pin goes straight through the ball.
TEST(Pins, DoNotPullClothThroughABall) {
  SimulationInput input = simulate_alone(sheet(0.3, 8, 0));
  input.gravity.setZero();
  input.colliders.push_back({"ball", SphereShape{0.1}, {}, 0.3});
  input.colliders[0].motion.at = Vec3(0.4, 0, 0);
  RigidMotion way;
  way.translate[0] = {{0.0, 0.0}, {1.0, 0.5}};
  input.cloths[0].pins.push_back({{31, 39}, way});
  Simulation simulation(input);
  double largest_lag = 0;
  for (int frame = 1; frame <= 30; ++frame) {
    largest_lag = std::max(largest_lag, simulation.advance_frame().largest_pin_lag);
    for (const Vec3& p : simulation.state().positions)
      EXPECT_GT((p - simulation.state().collider_poses[0].translation).norm(), 0.1) << "frame " << frame;
    EXPECT_EQ(intersecting_pairs(simulation), 0) << "frame " << frame;
  }
  EXPECT_GT(largest_lag, 0.02);
}

}  // namespace
}  // namespace drape
