#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "mass_spring_cloth.h"

namespace drape {
namespace {

using test::Random;
using test::spring_material;
using test::SpringCloth;

SpringCloth shaken_cloth(const ElasticMaterial& material, double speed = 0.5) {
  Random random(1);
  SpringCloth cloth(test::jittered_grid(9), material);
  cloth.x = test::shaken(cloth.x, 0.01, random);
  cloth.v = test::shaken(cloth.v, speed, random);
  return cloth;
}

Vec3 angular_momentum(const SpringCloth& cloth) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < cloth.x.size(); ++i) sum += cloth.masses[i] * cloth.x[i].cross(cloth.v[i]);
  return sum;
}

Vec3 momentum(const SpringCloth& cloth) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < cloth.x.size(); ++i) sum += cloth.masses[i] * cloth.v[i];
  return sum;
}

TEST(MassSpringStep, FreeFlightKeepsBothMomentaToRounding) {
  for (const double damping : {0.0, 0.001}) {
    SpringCloth cloth = shaken_cloth(spring_material(200, 1e-3, damping));
    const Vec3 linear = momentum(cloth), angular = angular_momentum(cloth);
    for (int n = 0; n < 2000; ++n) cloth.advance(cloth.model.stable_step);
    EXPECT_LT((momentum(cloth) - linear).norm(), 1e-12 * linear.norm());
    EXPECT_LT((angular_momentum(cloth) - angular).norm(), 1e-12 * angular.norm());
  }
}

TEST(MassSpringStep, OuterAccelerationsActOnEachPoint) {
  SpringCloth cloth(test::equilateral_pair(1, 0), spring_material(10, 0, 0));
  cloth.advance(0.01, {0, -9.81, 0});
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(cloth.v[i].y(), -0.0981, 1e-15);
    EXPECT_NEAR(cloth.x[i].y() - cloth.sheet.rest_positions[i].y(), -0.5 * 9.81 * 1e-4, 1e-15);
  }
}

// Halving the step quarters the error, with damping too.
TEST(MassSpringStep, LeapfrogIsOfSecondOrderInTime) {
  for (const double damping : {0.0, 0.001}) {
    const SpringCloth start = shaken_cloth(spring_material(50, 1e-3, damping));
    const double step = start.model.stable_step / 4;
    const auto after = [&](int parts) {
      SpringCloth cloth = start;
      for (int n = 0; n < 20 * parts; ++n) cloth.advance(step / parts, {0, -9.81, 0});
      return cloth;
    };
    const SpringCloth coarse = after(1), fine = after(2), finest = after(4);
    EXPECT_NEAR(test::farthest(coarse.x, fine.x) / test::farthest(fine.x, finest.x), 4, 0.2);
    EXPECT_NEAR(test::farthest(coarse.v, fine.v) / test::farthest(fine.v, finest.v), 4, 0.2);
  }
}

TEST(MassSpringStep, WithoutDampingItRunsBackwardsToWhereItBegan) {
  const SpringCloth start = shaken_cloth(spring_material(50, 1e-3, 0));
  SpringCloth cloth = start;
  const auto run = [&] {
    for (int n = 0; n < 100; ++n) cloth.advance(cloth.model.stable_step);
    for (Vec3& v : cloth.v) v = -v;
  };
  run();
  EXPECT_GT(test::farthest(cloth.x, start.x), 0.01);
  run();
  EXPECT_LT(test::farthest(cloth.x, start.x), 1e-10);
}

// A spring alone, and a bending element alone, lose their rate as e^(-d t), d = damping sum w |g|2.
TEST(MassSpringStep, DampingSetsTheRateAtWhichARateDiesOut) {
  constexpr double step = 1e-4;
  SpringCloth cloth(test::equilateral_pair(1, 0), spring_material(10, 1e-3, 0.001));
  for (Spring& spring : cloth.model.springs) spring.stiffness = spring.damping = 0;
  cloth.model.bending[0].stiffness = 0;
  const BendingElement element = cloth.model.bending[0];
  const std::array<Vec3, 4> gradients = bending_angle(element.vertices, cloth.x).gradients;
  double decay = 0;
  for (int i = 0; i < 4; ++i)
    decay += element.damping * cloth.model.inverse_masses[element.vertices[i]] * gradients[i].squaredNorm();
  const auto rate = [&] {
    double sum = 0;
    for (int i = 0; i < 4; ++i)
      sum += bending_angle(element.vertices, cloth.x).gradients[i].dot(cloth.v[element.vertices[i]]);
    return sum;
  };
  cloth.v[3] = {0, 1e-3, 0};
  const double before = rate();
  for (int n = 0; n < 500; ++n) cloth.advance(step);
  EXPECT_GT(decay, 0);
  EXPECT_NEAR(rate() / before, std::exp(-decay * 500 * step), 1e-5);
}

// Kelvin-Voigt's damping times stiffness where that is little, and else a twentieth of critical damping, 2
// sqrt(k / w).
TEST(MassSpringStep, DampingIsTheMaterialsUpToATwentiethOfCritical) {
  const auto spring_of = [](double damping) {
    const SpringCloth cloth(test::equilateral_pair(1, 0), spring_material(10, 0, damping));
    const Spring& spring = cloth.model.springs[0];
    const double response =
        cloth.model.inverse_masses[spring.vertices[0]] + cloth.model.inverse_masses[spring.vertices[1]];
    return std::pair(spring, 0.1 * std::sqrt(spring.stiffness / response));
  };
  const auto [little, unused] = spring_of(1e-5);
  EXPECT_DOUBLE_EQ(little.damping, 1e-5 * little.stiffness);
  const auto [much, most] = spring_of(1);
  EXPECT_DOUBLE_EQ(much.damping, most);
}

TEST(MassSpringStep, PinnedPointsStayAndHoldTheRest) {
  SpringCloth cloth(make_grid({1, 1}, {6, 6}), spring_material(200, 1e-5, 0.005), {0, 5});
  const std::vector<Vec3> before = cloth.x;
  while (cloth.v[35].y() <= 0) cloth.advance(cloth.model.stable_step, {0, -9.81, 0});
  EXPECT_EQ(cloth.x[0], before[0]);
  EXPECT_EQ(cloth.x[5], before[5]);
  EXPECT_LT(cloth.x[35].y(), -0.5);
  EXPECT_EQ(cloth.v[0], Vec3::Zero());
}

TEST(MassSpringStep, TheSameBitsWithAnyNumberOfThreads) {
  Random random(2);
  SpringCloth start(test::jittered_grid(40), spring_material(2000, 1e-4, 20), {0, 39});
  start.x = test::shaken(start.x, 0.01, random);
  std::vector<SpringCloth> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    results.push_back(start);
    for (int n = 0; n < 20; ++n) results.back().advance(start.model.stable_step, {0, -9.81, 0});
  }
  for (const int i : {1, 2}) {
    EXPECT_EQ(results[0].x, results[i].x);
    EXPECT_EQ(results[0].v, results[i].v);
  }
}

// How far the energy rises above that at the start, of a sheet that falls into its pins for half a second.
double energy_gain(const ElasticMaterial& material, double steps_of_bound, int points = 11) {
  Random random(3);
  const Vec3 gravity(0, -9.81, 0);
  SpringCloth cloth(make_grid({1, 1}, {points, points}), material, {0, points - 1});
  for (std::size_t i = 0; i < cloth.v.size(); ++i)
    if (cloth.model.inverse_masses[i] > 0) cloth.v[i] = random.vector(0.1);
  const double step = steps_of_bound * cloth.model.stable_step, start = cloth.energy(gravity);
  cloth.model.stable_step = std::numeric_limits<double>::infinity();
  double most = start;
  for (double time = 0; time < 0.5 && most < 1e6; time += step) {
    cloth.advance(step, gravity);
    most = std::max(most, cloth.energy(gravity));
  }
  return most - start;
}

std::vector<ElasticMaterial> many_materials() {
  return {spring_material(20000, 1e-5, 0), spring_material(200, 1e-5, 0), spring_material(200, 1e-3, 0),
          spring_material(2000, 1e-2, 0), spring_material(200, 1e-5, 0.005)};
}

// The sheet's weight times its height is 2 J.
TEST(MassSpringStep, AtTheLargestStableStepEnergyStaysBounded) {
  for (const ElasticMaterial& material : many_materials()) EXPECT_LT(energy_gain(material, 1), 1e-3);
  EXPECT_LT(energy_gain(spring_material(2000, 1e-3, 1), 1), 1e-3);  // with all the damping that there is
}

// So soft against its bending that triangles collapse.
TEST(MassSpringStep, TheBoundHoldsWhereTrianglesCollapse) {
  EXPECT_LT(energy_gain(spring_material(20, 1e-2, 0), 1, 32), 1e-3);
}

TEST(MassSpringStep, AtThreeTimesTheLargestStableStepItExplodes) {
  for (const ElasticMaterial& material : many_materials()) EXPECT_GT(energy_gain(material, 3), 1e6);
}

// A mass on one spring has omega2 = k (1/m + 1/m); the bound is Belytschko's with the damping of the spring.
TEST(MassSpringStep, TheBoundIsThatOfTheHighestFrequency) {
  SpringCloth cloth(test::equilateral_pair(1, 0), spring_material(10, 0, 0));
  cloth.model.springs.resize(1);
  cloth.model.bending.clear();
  cloth.model.inverse_masses = {2, 2, 2, 2};
  cloth.model.springs[0].stiffness = 25;
  EXPECT_DOUBLE_EQ(largest_stable_step(cloth.model), 2 / 10.0);
  cloth.model.springs[0].damping = 3;  // c = 12, xi = 0.6
  EXPECT_DOUBLE_EQ(largest_stable_step(cloth.model), 2 / 10.0 * (std::sqrt(1.36) - 0.6));
  cloth.model.inverse_masses = {0, 0, 0, 0};
  EXPECT_EQ(largest_stable_step(cloth.model), std::numeric_limits<double>::infinity());
}

TEST(MassSpringStep, TheBoundFallsWithTheRootOfStiffnessAndWithTheEdge) {
  const auto bound = [](int points, double stretch) {
    return SpringCloth(make_grid({1, 1}, {points, points}), spring_material(stretch, 0, 0)).model.stable_step;
  };
  EXPECT_NEAR(bound(11, 400) / bound(11, 100), 0.5, 1e-12);
  EXPECT_NEAR(bound(21, 100) / bound(11, 100), 0.5, 1e-12);
}

TEST(MassSpringStep, ALargerStepIsRefusedInWords) {
  SpringCloth cloth(make_grid({1, 1}, {11, 11}), spring_material(20000, 1e-5, 0));
  const std::vector<Vec3> before = cloth.x;
  cloth.model.stable_step = 0.00018;
  try {
    cloth.advance(0.005, {0, -9.81, 0});
    FAIL() << "no error";
  } catch (const SimulationError& error) {
    EXPECT_STREQ(
        error.what(),
        "the mass-spring model is explicit and stable for steps of at most 0.00018 s; a step of 0.005 s "
        "would make it explode: take 28 times as many steps, or a softer or heavier material");
  }
  EXPECT_EQ(cloth.x, before);
}

}  // namespace
}  // namespace drape
