#include <gtest/gtest.h>

#include <numbers>

#include "deformation/bending.h"
#include "sheets.h"

namespace drape {
namespace {

using test::equilateral_pair;
using test::Random;
using test::sheet_of;

constexpr double step = 1.0 / 240;

Vec3 residual(const Hinge& hinge, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 4; ++i) sum += hinge.weights[i] * x[hinge.vertices[i]];
  return sum;
}

double energy(const HingeStage& stage, const std::vector<Vec3>& x) {
  double sum = 0;
  for (const Hinge& hinge : stage.hinges) {
    const double excess = residual(hinge, x).norm() - hinge.rest_residual;
    sum += 0.5 * hinge.stiffness * excess * excess;
  }
  return sum;
}

std::vector<Vec3> pulled(const HingeStage& stage, const std::vector<double>& inverse_masses,
                         std::vector<Vec3> x) {
  pull_hinges(stage, inverse_masses, step, x);
  return x;
}

TEST(Bending, EveryInnerEdgeHasOneHinge) {
  const Sheet sheet = sheet_of(test::jittered_grid(6));
  const HingeStage stage = build_hinges(sheet);
  EXPECT_EQ(stage.hinges.size(), sheet.topology.edges.size() - 4 * 5);
  EXPECT_EQ(stage.color_begin.back(), stage.hinges.size());
  EXPECT_EQ(build_hinges(sheet_of(test::tetrahedron())).hinges.size(), 6u);
}

TEST(Bending, AnAffineImageOfAFlatSheetHasNoResidual) {
  Random random(1);
  const Sheet sheet = sheet_of(test::jittered_grid(8));
  const HingeStage stage = build_hinges(sheet);
  const std::vector<Vec3> x = test::moved(sheet.rest_positions, random.matrix(), random.vector());
  for (const Hinge& hinge : stage.hinges) {
    EXPECT_LT(residual(hinge, x).norm(), 1e-13);
    EXPECT_EQ(hinge.rest_residual, 0);
  }
  const std::vector<double> inverse_masses(x.size(), 100);
  EXPECT_LT(test::farthest(x, pulled(stage, inverse_masses, x)), 1e-14);
}

TEST(Bending, ResidualGrowsWithTheFirstPowerOfTheAngle) {
  const double side = 0.03;
  const HingeStage stage = build_hinges(sheet_of(equilateral_pair(side, 0)));
  ASSERT_EQ(stage.hinges.size(), 1u);
  for (const double angle : {1e-6, 0.1, 1.0, 2.0, std::numbers::pi}) {
    const double length = residual(stage.hinges[0], equilateral_pair(side, angle).positions).norm();
    EXPECT_NEAR(length, side * 2 * std::sin(angle / 2), 1e-15);
  }
}

TEST(Bending, StiffnessIsThatOfTheRigidityOverTheArea) {
  ElasticMaterial material;
  material.bend_stiffness = 2e-4;
  const Hinge hinge = build_hinges(sheet_of(equilateral_pair(0.1, 0), material)).hinges[0];
  EXPECT_NEAR(hinge.stiffness, 3 * 2e-4 / (2 * std::sqrt(3) / 4 * 0.01), 1e-12);
  EXPECT_EQ(hinge.damping, material.damping);
}

TEST(Bending, AHingeKeepsBothMomenta) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    TriangleMesh mesh = equilateral_pair(1, random.between(-1, 1));
    mesh.positions = test::shaken(mesh.positions, 0.2, random);
    ElasticMaterial material;
    material.bend_stiffness = 1e4;
    const HingeStage stage = build_hinges(sheet_of(mesh, material));
    const std::vector<double> masses = test::random_masses(4, random);
    const std::vector<Vec3> before = test::shaken(mesh.positions, 1, random);
    const std::vector<Vec3> after = pulled(stage, test::inverses(masses), before);
    ASSERT_GT(test::farthest(before, after), 1e-3);
    EXPECT_LT(test::relative_momentum(masses, before, after), 1e-13);
    EXPECT_LT(test::relative_angular_momentum(masses, before, after), 1e-13);
  }
}

TEST(Bending, ASheetKeepsItsLinearMomentum) {
  Random random(3);
  const Sheet sheet = sheet_of(test::jittered_grid(10), {.bend_stiffness = 1});
  const std::vector<double> masses = test::random_masses(100, random);
  const std::vector<Vec3> before = test::shaken(sheet.rest_positions, 0.05, random);
  const std::vector<Vec3> after = pulled(build_hinges(sheet), test::inverses(masses), before);
  EXPECT_LT(test::relative_momentum(masses, before, after), 1e-14);
}

TEST(Bending, APullNeverOvershootsAndTakesItsImplicitShare) {
  Random random(4);
  for (const double bend_stiffness : {1e-6, 1e-2, 1e2, 1e8}) {
    const Sheet sheet = sheet_of(equilateral_pair(1, 0), {.bend_stiffness = bend_stiffness});
    const HingeStage stage = build_hinges(sheet);
    const Hinge& hinge = stage.hinges[0];
    const std::vector<double> inverse_masses(4, 2);
    const std::vector<Vec3> before = equilateral_pair(1, 1).positions;
    const Vec3 r = residual(hinge, before), left = residual(hinge, pulled(stage, inverse_masses, before));
    double response = 0;
    for (const double weight : hinge.weights) response += 2 * weight * weight;
    const double share = 1 / (1 + hinge.stiffness * step * step * response);
    EXPECT_LT((left - share * r).norm(), 1e-14);
  }
}

TEST(Bending, EnergyNeverIncreasesOverPulls) {
  Random random(5);
  for (const double bend_stiffness : {1e-5, 1e-2, 10.0}) {
    const Sheet sheet = sheet_of(test::jittered_grid(10), {.bend_stiffness = bend_stiffness});
    const HingeStage stage = build_hinges(sheet);
    const std::vector<double> inverse_masses = test::inverses(lumped_masses(sheet));
    std::vector<Vec3> x = test::shaken(sheet.rest_positions, 0.05, random);
    for (int sweep = 0; sweep < 50; ++sweep) {
      const double before = energy(stage, x);
      pull_hinges(stage, inverse_masses, step, x);
      ASSERT_LE(energy(stage, x), before * (1 + 1e-12)) << "sweep " << sweep;
    }
  }
}

// Each pull is the nearest-point step of a convex potential that is least at every flat shape.
TEST(Bending, NoPullLeadsAwayFromTheFlatShape) {
  Random random(6);
  const Sheet sheet = sheet_of(test::jittered_grid(10), {.bend_stiffness = 0.1});
  const HingeStage stage = build_hinges(sheet);
  const std::vector<double> masses = lumped_masses(sheet);
  const auto distance = [&](const std::vector<Vec3>& x) {
    double sum = 0;
    for (std::size_t v = 0; v < x.size(); ++v)
      sum += masses[v] * (x[v] - sheet.rest_positions[v]).squaredNorm();
    return sum;
  };
  std::vector<Vec3> x = test::shaken(sheet.rest_positions, 0.05, random);
  for (int sweep = 0; sweep < 50; ++sweep) {
    const double before = distance(x);
    pull_hinges(stage, test::inverses(masses), step, x);
    ASSERT_LE(distance(x), before);
  }
}

TEST(Bending, ACurvedRestShapeStaysWhereverItIsMoved) {
  Random random(7);
  const Sheet sheet = sheet_of(make_sphere(0.3, 14, 9), {.bend_stiffness = 1});
  const std::vector<double> inverse_masses = test::inverses(lumped_masses(sheet));
  const std::vector<Vec3> x = test::moved(sheet.rest_positions, random.rotation(), random.vector());
  EXPECT_LT(test::farthest(x, pulled(build_hinges(sheet), inverse_masses, x)), 1e-14);
}

TEST(Bending, AFlattenedCurvedShapeComesBackToItsCurvature) {
  const Sheet sheet = sheet_of(equilateral_pair(1, 0.8), {.bend_stiffness = 1e9});
  const HingeStage stage = build_hinges(sheet);
  const std::vector<double> inverse_masses(4, 1);
  const std::vector<Vec3> x = pulled(stage, inverse_masses, equilateral_pair(1, 0.3).positions);
  EXPECT_NEAR(residual(stage.hinges[0], x).norm(), 2 * std::sin(0.4), 1e-4);
}

TEST(Bending, PinnedPointsStay) {
  const Sheet sheet = sheet_of(equilateral_pair(1, 0), {.bend_stiffness = 1e3});
  const std::vector<Vec3> before = equilateral_pair(1, 1).positions;
  const std::vector<Vec3> after = pulled(build_hinges(sheet), {0, 1, 1, 0}, before);
  EXPECT_EQ(after[0], before[0]);
  EXPECT_EQ(after[3], before[3]);
  EXPECT_GT((after[2] - before[2]).norm(), 1e-3);
  EXPECT_EQ(pulled(build_hinges(sheet), {0, 0, 0, 0}, before), before);
}

TEST(BendingDamping, LeavesRigidAndInPlaneMotionOfAFlatSheet) {
  Random random(8);
  const Sheet sheet = sheet_of(test::jittered_grid(8), {.damping = 50});
  const std::vector<double> inverse_masses = test::inverses(lumped_masses(sheet));
  const std::vector<Vec3> rigid = test::moved(sheet.rest_positions, random.matrix(), random.vector());
  std::vector<Vec3> velocities = rigid;
  damp_bending(build_hinges(sheet), inverse_masses, step, velocities);
  EXPECT_LT(test::farthest(rigid, velocities), 1e-13);
}

TEST(BendingDamping, TakesItsShareOfTheRateOfBending) {
  const HingeStage stage = build_hinges(sheet_of(equilateral_pair(1, 0), {.damping = 30}));
  std::vector<Vec3> velocities = {{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 2, 0}};
  const Vec3 before = residual(stage.hinges[0], velocities);
  damp_bending(stage, {1, 2, 3, 4}, step, velocities);
  const double left = 1 / (1 + 30 * step);
  EXPECT_LT((residual(stage.hinges[0], velocities) - left * before).norm(), 1e-15);
}

TEST(BendingDamping, KeepsLinearMomentumAndLowersKineticEnergy) {
  Random random(9);
  const Sheet sheet = sheet_of(test::jittered_grid(8), {.damping = 50});
  const std::vector<double> masses = lumped_masses(sheet);
  const std::vector<Vec3> before = test::shaken(std::vector<Vec3>(64, Vec3(1, 2, 3)), 1, random);
  std::vector<Vec3> after = before;
  damp_bending(build_hinges(sheet), test::inverses(masses), step, after);
  EXPECT_LT(test::relative_momentum(masses, before, after), 1e-14);
  double kinetic_before = 0, kinetic_after = 0;
  for (int v = 0; v < 64; ++v) {
    kinetic_before += masses[v] * before[v].squaredNorm();
    kinetic_after += masses[v] * after[v].squaredNorm();
  }
  EXPECT_LT(kinetic_after, 0.99 * kinetic_before);
}

}  // namespace
}  // namespace drape
