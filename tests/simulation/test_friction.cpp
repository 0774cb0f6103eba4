#include <gtest/gtest.h>

#include <cmath>

#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

constexpr double slope = 0.5;  // the tangent of the plane's angle

// A small sheet that lies on an inclined plane; its speed down the slope after one second.
double speed_on_slope(double friction) {
  const double degrees = std::atan(slope) * 180 / 3.14159265358979323846;
  ColliderInput plane{"slope", PlaneShape{}, {}, friction};
  plane.motion.rotate = Vec3(0, 0, -degrees);
  ClothInput cloth = sheet(0.3, 10, 0);
  cloth.material.friction = friction;
  const RigidPose pose = pose_at(plane.motion, 0);
  for (Vec3& p : cloth.start_positions) p = pose(p + Vec3(0, cloth.material.thickness, 0));
  SimulationInput input = simulate_alone(cloth);
  input.colliders.push_back(plane);
  remove_air(input);
  Simulation simulation(input);
  advance(simulation, 30);
  Vec3 mean = Vec3::Zero();
  for (const Vec3& v : simulation.state().velocities) mean += v / 100;
  return mean.norm();
}

double expected_speed(double friction) {
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  return 9.81 * cosine * (slope - friction);
}

TEST(Friction, ASheetSlidesDownASlopeAsCoulombSays) {
  // One step more or less of a second's 510 is 0.2 %.
  for (const double friction : {0.0, 0.3, 0.45})
    EXPECT_NEAR(speed_on_slope(friction), expected_speed(friction), 0.005 * expected_speed(friction))
        << friction;
}

TEST(Friction, ASheetStaysOnASlopeUnderTheAngleOfFriction) { EXPECT_LT(speed_on_slope(0.55), 1e-3); }

TEST(Friction, ATurningSphereDragsTheClothWithIt) {
  ColliderInput ball{"ball", SphereShape{0.2}, {}, 0.8};
  ball.motion.turn[1] = {{0.0, 0.0}, {1.0, 90.0}};
  ClothInput cloth = sheet(0.2, 14, 0.206);
  cloth.material.friction = 0.8;
  SimulationInput input = simulate_alone(cloth);
  input.colliders.push_back(ball);
  Simulation simulation(input);
  advance(simulation, 30);
  // The middle of the edge along +x turns towards -z about +y.
  const Vec3 edge = simulation.state().positions[7 * 14 + 13] - simulation.state().positions[7 * 14];
  const double turned = std::atan2(-edge.z(), edge.x()) * 180 / 3.14159265358979323846;
  EXPECT_GT(turned, 70);
  EXPECT_LT(turned, 95);
}

}  // namespace
}  // namespace drape
