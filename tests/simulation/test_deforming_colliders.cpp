#include <gtest/gtest.h>

#include "certificate/surface_certificate.h"
#include "mesh/primitives.h"
#include "simulation/colliders.h"
#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

constexpr double frame_time = 1.0 / 30;

// The shapes of a mesh at the frames 0, 1, ...: its points after `deform` with each of the amounts.
template <typename Deform>
ColliderInput sequence(const TriangleMesh& mesh, const std::vector<double>& amounts, const Deform& deform) {
  MeshShape shape{mesh, {}, 0, frame_time};
  for (const double amount : amounts) {
    shape.shapes.push_back(mesh.positions);
    for (Vec3& p : shape.shapes.back()) p = deform(p, amount);
  }
  shape.mesh.positions = shape.shapes.front();
  ColliderInput collider;
  collider.name = "body";
  collider.shape = std::move(shape);
  return collider;
}

// A box on the ground whose upper face rises.
ColliderInput rising_box(const std::vector<double>& heights) {
  return sequence(make_box({0.3, 0.2, 0.3}), heights,
                  [](const Vec3& p, double height) { return Vec3(p.x(), p.y() > 0 ? height : 0, p.z()); });
}

// One mesh of two boxes, one over the other, that come together, and through each other by as much as
// `amounts` are below zero.
ColliderInput jaws(const std::vector<double>& amounts) {
  TriangleMesh mesh = make_box({0.2, 0.1, 0.2});
  const TriangleMesh upper = make_box({0.2, 0.1, 0.2});
  const int first = static_cast<int>(mesh.positions.size());
  for (const Vec3& p : upper.positions) mesh.positions.push_back(p + Vec3(0, 1, 0));
  for (const auto& [a, b, c] : upper.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
  return sequence(mesh, amounts, [](const Vec3& p, double gap) {
    return Vec3(p.x(), p.y() > 0.5 ? p.y() - 0.95 + 0.5 * gap : p.y() - 0.05 - 0.5 * gap, p.z());
  });
}

int triangles_in_collider(const Simulation& simulation) {
  const MeshShape& shape = std::get<MeshShape>(simulation.input().colliders.front().shape);
  return static_cast<int>(triangles_that_meet(simulation.state().positions,
                                              simulation.input().cloths.front().mesh.triangles,
                                              simulation.state().collider_points, shape.mesh.triangles)
                              .size());
}

TEST(DeformingCollider, GoesStraightFromShapeToShapeAndRestsBeforeAndAfterThem) {
  ColliderInput box = rising_box({0.2, 0.3, 0.5});
  std::get<MeshShape>(box.shape).first_time = frame_time;
  const auto height = [&](double frame) {
    double highest = 0;
    for (const Vec3& p : collider_points(box, frame * frame_time)) highest = std::max(highest, p.y());
    return highest;
  };
  EXPECT_DOUBLE_EQ(height(0), 0.2);
  EXPECT_DOUBLE_EQ(height(1), 0.2);
  EXPECT_NEAR(height(1.5), 0.25, 1e-12);
  EXPECT_NEAR(height(2), 0.3, 1e-12);
  EXPECT_NEAR(height(2.75), 0.45, 1e-12);
  EXPECT_DOUBLE_EQ(height(9), 0.5);
}

TEST(DeformingCollider, MovesAsAWholeToo) {
  ColliderInput box = rising_box({0.2, 0.4});
  box.motion.at = Vec3(3, 0, 0);
  double highest = 0;
  for (const Vec3& p : collider_points(box, 0.5 * frame_time)) {
    EXPECT_NEAR(std::abs(p.x() - 3), 0.15, 1e-12);
    highest = std::max(highest, p.y());
  }
  EXPECT_NEAR(highest, 0.3, 1e-12);
}

TEST(DeformingCollider, LiftsTheClothThatLiesOnIt) {
  SimulationInput input = simulate_alone(sheet(0.4, 12, 0.206));
  std::vector<double> heights;
  for (int i = 0; i <= 20; ++i) heights.push_back(0.2 + 0.01 * std::clamp(i - 5, 0, 10));
  input.colliders = {rising_box(heights)};
  Simulation simulation(input);
  for (int frame = 0; frame < 25; ++frame) {
    const FrameStatistics statistics = simulation.advance_frame();
    EXPECT_EQ(triangles_in_collider(simulation), 0) << frame;
    EXPECT_EQ(intersecting_pairs(simulation), 0) << frame;
    EXPECT_LT(statistics.largest_shape_lag, 1e-9) << frame;
  }
  const Vec3& middle = simulation.state().positions[12 * 6 + 6];
  EXPECT_NEAR(middle.y(), 0.305, 0.002);
}

// It closes over the cloth to less than nothing: it gives way to the cloth, and only where that is.
TEST(DeformingCollider, ThatMeetsItselfYieldsToTheClothInBetween) {
  SimulationInput input = simulate_alone(sheet(0.1, 8, 0));
  input.gravity = Vec3::Zero();
  std::vector<double> gaps;
  for (int i = 0; i <= 30; ++i) gaps.push_back(i < 15 ? 0.1 - 0.008 * i : -0.012 + 0.008 * (i - 15));
  input.colliders = {jaws(gaps)};
  Simulation simulation(input);
  double largest_lag = 0;
  for (int frame = 0; frame < 40; ++frame) {
    const FrameStatistics statistics = simulation.advance_frame();
    EXPECT_EQ(triangles_in_collider(simulation), 0) << frame;
    EXPECT_EQ(intersecting_pairs(simulation), 0) << frame;
    largest_lag = std::max(largest_lag, statistics.largest_shape_lag);
  }
  EXPECT_GT(largest_lag, 0.005);
  EXPECT_LT(largest_lag, 0.02);
  const double now = simulation.state().frame * frame_time;
  EXPECT_LT(largest_shape_lag(simulation.input().colliders, now, simulation.state().collider_points), 1e-9);
}

TEST(DeformingCollider, GoesOnFromACheckpointWithTheSameBits) {
  SimulationInput input = simulate_alone(sheet(0.1, 8, 0));
  input.colliders = {jaws({0.1, 0.06, 0.02, -0.02, 0.02, 0.06})};
  Simulation whole(input), part(input), resumed(input);
  advance(whole, 6);
  advance(part, 3);
  resumed.restore(part.state());
  advance(resumed, 3);
  EXPECT_EQ(state_hash(resumed.state()), state_hash(whole.state()));
}

}  // namespace
}  // namespace drape
