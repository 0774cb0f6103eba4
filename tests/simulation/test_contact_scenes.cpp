#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

TEST(ContactScenes, NothingGoesUnderTheGround) {
  SimulationInput input = simulate_alone(standing_sheet(0.5, 20, 0.02));
  input.cloths[0].start_positions[0].z() += 1e-3;  // so that it knows where to fall
  input.colliders.push_back(ground());
  Simulation simulation(input);
  for (int frame = 0; frame < 45; ++frame) {
    simulation.advance_frame();
    ASSERT_GT(lowest_point(simulation), 0) << "frame " << frame + 1;
  }
  EXPECT_GT(lowest_point(simulation), 0.8 * input.cloths[0].material.thickness);
}

TEST(ContactScenes, ASheetThatFoldsOverItselfNeverIntersects) {
  SimulationInput input = simulate_alone(standing_sheet(0.5, 24, 0.01));
  for (Vec3& p : input.cloths[0].start_positions) p.z() += 0.01 * p.y();
  input.cloths[0].material.thickness = 0.004;
  input.colliders.push_back(ground());
  Simulation simulation(input);
  for (int frame = 0; frame < 45; ++frame) {
    simulation.advance_frame();
    ASSERT_EQ(intersecting_pairs(simulation), 0) << "frame " << frame + 1;
  }
}

double total_mass(const Simulation& simulation) {
  const std::vector<double> masses = point_masses(simulation);
  return std::accumulate(masses.begin(), masses.end(), 0.0);
}

TEST(ContactScenes, AHeapOfFoldsComesToRest) {
  SimulationInput input = simulate_alone(standing_sheet(0.5, 24, 0.01));
  for (Vec3& p : input.cloths[0].start_positions) p.z() += 0.01 * p.y();
  input.colliders.push_back(ground());
  Simulation simulation(input);
  const FrameStatistics statistics = advance(simulation, 120);
  EXPECT_LT(statistics.kinetic_energy / total_mass(simulation), 1e-7);  // J/kg
}

TEST(ContactScenes, AStackOfSheetsComesToRest) {
  SimulationInput input;
  input.sleep = false;
  for (int layer = 0; layer < 5; ++layer) {
    input.cloths.push_back(sheet(0.3, 12, 0.01 + 0.012 * layer));
    for (Vec3& p : input.cloths.back().start_positions) p += layer * Vec3(0.007, 0, 0.003);
  }
  input.colliders.push_back(ground());
  Simulation simulation(input);
  const FrameStatistics statistics = advance(simulation, 20);
  EXPECT_LT(statistics.kinetic_energy / total_mass(simulation), 1e-10);
}

// The blow of the first step is not what holds them in the next.
TEST(ContactScenes, SheetsThatLandTogetherDoNotBounce) {
  SimulationInput input;
  for (int layer = 0; layer < 20; ++layer) input.cloths.push_back(sheet(0.3, 7, 0.1 + 0.00502 * layer));
  remove_air(input);
  input.colliders.push_back(ground());
  Simulation simulation(input);
  for (int frame = 0; frame < 10; ++frame) {
    simulation.advance_frame();
    EXPECT_LT(linear_momentum(simulation).y() / total_mass(simulation), 0.02)
        << "frame " << frame + 1;  // m/s
  }
}

// A ball that is sent at 25 m/s against a sheet that cannot give way, and would stop at a key behind it.
TEST(ContactScenes, ABallThatIsHeldUpIsWhereItsClockSays) {
  SimulationInput input = simulate_alone(standing_sheet(0.3, 12, 0.2));
  for (int v = 0; v < 144; ++v) input.cloths[0].pins.push_back({{v}});
  ColliderInput ball{"ball", SphereShape{0.05}, {}, 0.3};
  ball.motion.at = Vec3(0, 0.35, -0.3);
  ball.motion.translate[2] = {{0.0, 0.0}, {0.0204, 0.5}};  // no multiple of the step
  input.colliders.push_back(ball);
  input.frame_duration = 0.005;
  Simulation simulation(input);
  double largest_lag = 0;
  for (int frame = 0; frame < 20; ++frame) {
    largest_lag = std::max(largest_lag, simulation.advance_frame().largest_lag);
    const State& state = simulation.state();
    EXPECT_LT((state.collider_points[0] - state.collider_poses[0].translation).norm(), 1e-9) << frame;
    EXPECT_EQ(intersecting_pairs(simulation), 0);
  }
  EXPECT_GT(largest_lag, 1e-4);
}

// It is on the far side of the sheet at the end of its first step: which side counts is where it comes from.
TEST(ContactScenes, ASmallBallThatGoesItsOwnWidthInAStepTakesClothAlong) {
  SimulationInput input = simulate_alone(sheet(0.02, 2, 0.0));
  input.gravity.setZero();
  input.largest_step = 0.002;
  input.cloths[0].material.thickness = 0.001;
  ColliderInput ball{"ball", SphereShape{0.005}, {}, 0.3};
  ball.motion.at = Vec3(0.002, -0.008, 0.001);
  ball.motion.translate[1] = {{0.0, 0.0}, {1.0, 10.0}};
  input.colliders.push_back(ball);
  Simulation simulation(input);
  EXPECT_LT(advance(simulation, 1).largest_lag, 0.001);
  EXPECT_GT(lowest_point(simulation), 0.2);
}

TEST(ContactScenes, FoldingLeavesNoEdgeFarFromItsLength) {
  SimulationInput input = simulate_alone(standing_sheet(0.5, 40, 0.01));
  for (Vec3& p : input.cloths[0].start_positions) p.z() += 0.01 * p.y();
  input.colliders.push_back(ground());
  Simulation simulation(input);
  for (int frame = 0; frame < 30; ++frame) {
    const FrameStatistics statistics = simulation.advance_frame();
    ASSERT_LT(statistics.largest_stretch, 1.03) << "frame " << frame + 1;
    ASSERT_GT(statistics.smallest_stretch, 0.92) << "frame " << frame + 1;
  }
}

TEST(ContactScenes, ASheetOnASphereKeepsItsThickness) {
  SimulationInput input = simulate_alone(sheet(0.8, 26, 0.31));
  input.colliders.push_back({"ball", SphereShape{0.3}, {}, 0.3});
  Simulation simulation(input);
  for (int frame = 0; frame < 45; ++frame) simulation.advance_frame();
  double nearest = 1;
  for (const Vec3& p : simulation.state().positions) nearest = std::min(nearest, p.norm() - 0.3);
  EXPECT_GT(nearest, 0.0045);
  EXPECT_LT(nearest, 0.0055);  // it lies on the sphere, and does not float
  EXPECT_EQ(intersecting_pairs(simulation), 0);
}

TEST(ContactScenes, ClothThatStartsALittleInsideABallComesOutOfIt) {
  SimulationInput input = simulate_alone(sheet(0.1, 6, 0.501));
  input.gravity.setZero();
  input.colliders.push_back({"ball", SphereShape{0.5}, {}, 0.3});
  Simulation simulation(input);
  const FrameStatistics statistics = advance(simulation, 10);
  for (const Vec3& p : simulation.state().positions)
    EXPECT_GT(p.norm() - 0.5, 0.85 * input.cloths[0].material.thickness);
  EXPECT_LT(statistics.largest_speed, 0.1);  // it is not thrown out
}

TEST(ContactScenes, TwoLayersLieOnEachOther) {
  SimulationInput input;
  input.cloths = {sheet(0.4, 16, 0.006), sheet(0.4, 16, 0.02)};
  input.colliders.push_back(ground());
  Simulation simulation(input);
  advance(simulation, 30);
  for (std::size_t v = 0; v < 256; ++v) {
    EXPECT_NEAR(simulation.state().positions[v].y(), 0.005, 1e-4);
    EXPECT_NEAR(simulation.state().positions[v + 256].y(), 0.010, 3e-4);
  }
  EXPECT_EQ(intersecting_pairs(simulation), 0);
}

TEST(ContactScenes, ARoundTableHoldsWhatLiesOnItAndLetsTheRestHang) {
  SimulationInput input = simulate_alone(sheet(0.3, 16, 0.006));
  ColliderInput table{"table", CylinderShape{0.1, 0.02}, {}, 0.3};
  table.motion.at = Vec3(0, -0.01, 0);
  input.colliders.push_back(table);
  Simulation simulation(input);
  advance(simulation, 20);
  for (const Vec3& p : simulation.state().positions) {
    const double from_axis = std::hypot(p.x(), p.z());
    if (from_axis < 0.099) {
      EXPECT_TRUE(p.y() > 0 || p.y() < -0.02) << p.transpose();  // what hangs may swing in under the table
    }
    if (from_axis < 0.06) {
      EXPECT_LT(p.y(), 0.01);  // bending lifts the middle a little
    }
  }
  EXPECT_LT(lowest_point(simulation), -0.03);
  EXPECT_EQ(intersecting_pairs(simulation), 0);
}

TEST(ContactScenes, ABoxThatComesDownOnClothStopsAtItRatherThanPassThrough) {
  SimulationInput input = simulate_alone(sheet(0.3, 12, 0.006));
  input.colliders.push_back(ground());
  ColliderInput box{"press", BoxShape{Vec3(0.2, 0.1, 0.2)}, {}, 0.3};
  box.motion.at = Vec3(0, 0.1, 0);
  box.motion.translate[1] = {{0.0, 0.0}, {0.3, -0.06}};  // its lower face would end 10 mm under the ground
  input.colliders.push_back(box);
  Simulation simulation(input);
  const FrameStatistics statistics = advance(simulation, 15);
  EXPECT_GT(lowest_point(simulation), 0);
  EXPECT_GT(statistics.largest_lag, 0.01);
  const double lower_face = simulation.state().collider_poses[1].translation.y() - 0.05;
  for (const Vec3& p : simulation.state().positions) {
    if (std::abs(p.x()) < 0.1 && std::abs(p.z()) < 0.1) {
      EXPECT_LT(p.y(), lower_face);
    }
  }
}

TEST(ContactScenes, AFastSphereDoesNotPassThroughAPinnedSheet) {
  ClothInput cloth = standing_sheet(1, 24, 0);
  PinInput pin;
  for (int i = 0; i < 24; ++i)
    for (const int v : {i, 23 * 24 + i, 24 * i, 24 * i + 23}) pin.vertices.push_back(v);
  cloth.pins.push_back(pin);
  SimulationInput input = simulate_alone(cloth);
  ColliderInput ball{"ball", SphereShape{0.1}, {}, 0.3};
  ball.motion.at = Vec3(0, 0.5, 1);
  ball.motion.translate[2] = {{0.0, 0.0}, {0.1, -1.1}};
  input.colliders.push_back(ball);
  Simulation simulation(input);
  for (int frame = 0; frame < 4; ++frame) {
    simulation.advance_frame();
    ASSERT_EQ(intersecting_pairs(simulation), 0);
    const Vec3 centre = simulation.state().collider_poses[0].translation;
    for (const Vec3& p : simulation.state().positions) ASSERT_GT((p - centre).norm(), 0.1);
  }
}

TEST(ContactScenes, TwoSheetsThatMeetKeepTheirMomentum) {
  SimulationInput input;
  remove_air(input);
  input.gravity.setZero();
  input.cloths = {sheet(0.3, 12, 0), sheet(0.2, 9, 0.02)};
  Simulation simulation(input);
  State state = simulation.state();
  for (std::size_t v = 144; v < state.velocities.size(); ++v) state.velocities[v] = Vec3(0.2, -2, 0.1);
  simulation.restore(state);
  const Vec3 before = linear_momentum(simulation);
  advance(simulation, 5);
  Vec3 lower = Vec3::Zero();
  for (std::size_t v = 0; v < 144; ++v) lower += simulation.state().velocities[v] / 144;
  EXPECT_LT(lower.y(), -0.2);  // the upper sheet has set the lower one in motion
  EXPECT_LT((linear_momentum(simulation) - before).norm(), 1e-10);
}

}  // namespace
}  // namespace drape
