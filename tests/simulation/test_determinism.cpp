#include <gtest/gtest.h>

#include "core/hash.h"
#include "core/parallel.h"
#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

// Folds, a sphere, the ground, two cloths, a pin and wind: every kind of work that may run in parallel.
SimulationInput busy_scene() {
  SimulationInput input;
  input.cloths = {sheet(0.7, 45, 0.41), sheet(0.3, 20, 0.45)};
  input.cloths[0].pins.push_back({{0}, {}, {}});
  input.cloths[1].pins.push_back({{0, 1}, {}, {}, 5 * input.frame_duration, 1});
  input.colliders = {ground(), {"ball", SphereShape{0.2}, {}, 0.3}};
  input.colliders[1].motion.at = Vec3(0, 0.2, 0);
  input.colliders[1].motion.turn[1] = {{0.0, 0.0}, {1.0, 90.0}};
  input.wind.velocity = Vec3(1, 0, 0);
  input.wind.gust = 0.5;
  return input;
}

std::uint64_t hash_with_threads(int threads) {
  const ThreadLimit limit(threads);
  Simulation simulation(busy_scene());
  advance(simulation, 12);
  return state_hash(simulation.state());
}

TEST(Determinism, EqualBitsForAnyNumberOfThreads) {
  const std::uint64_t one = hash_with_threads(1);
  for (const int threads : {2, 4, 8}) EXPECT_EQ(hash_with_threads(threads), one) << threads << " threads";
}

TEST(Determinism, AResumedRunGivesTheSameBitsAsOneThatNeverStopped) {
  Simulation whole(busy_scene());
  advance(whole, 6);
  const State checkpoint = whole.state();
  ASSERT_FALSE(checkpoint.remembered_contacts.empty());
  advance(whole, 6);
  Simulation resumed(busy_scene());
  resumed.restore(checkpoint);
  advance(resumed, 6);
  EXPECT_EQ(state_hash(resumed.state()), state_hash(whole.state()));
}

TEST(Determinism, TheHashSeesEachPartOfTheState) {
  const Simulation simulation(busy_scene());
  const State& state = simulation.state();
  const std::uint64_t hash = state_hash(state);
  State changed = state;
  changed.positions.back().z() += 1e-15;
  EXPECT_NE(state_hash(changed), hash);
  changed = state;
  changed.velocities.front().x() = -0.0;
  EXPECT_NE(state_hash(changed), hash);
  changed = state;
  changed.collider_times[1] += 1e-18;
  EXPECT_NE(state_hash(changed), hash);
  changed = state;
  changed.grabs[0].x() += 1e-15;
  EXPECT_NE(state_hash(changed), hash);
  changed = state;
  changed.remembered_contacts.push_back({{0, 0}, {1, 2, 3, 4}, 0, {1e-9, Vec3::Zero(), 0}});
  EXPECT_NE(state_hash(changed), hash);
  changed = state;
  ++changed.contacts;
  EXPECT_NE(state_hash(changed), hash);
  changed = state;
  changed.still_positions.back().y() += 1e-15;
  EXPECT_NE(state_hash(changed), hash);
  changed = state;
  changed.later_positions.back().y() += 1e-15;
  EXPECT_NE(state_hash(changed), hash);
  changed = state;
  ++changed.still_since;
  EXPECT_NE(state_hash(changed), hash);
  changed = state;
  ++changed.frame;
  EXPECT_NE(state_hash(changed), hash);
}

// The hash of one small scene, the same for every compiler and machine that the project supports. It changes
// with the model and with the order of its sums: then put the new one here, and say why in the commit.
TEST(Determinism, TheHashOfASmallSceneIsTheOneOnRecord) {
  SimulationInput input = simulate_alone(sheet(0.5, 16, 0.21));
  input.colliders = {ground(), {"ball", SphereShape{0.2}, {}, 0.3}};
  Simulation simulation(input);
  advance(simulation, 10);
  EXPECT_EQ(to_hex(state_hash(simulation.state())), "ed8913c089975b54");
}

}  // namespace
}  // namespace drape
