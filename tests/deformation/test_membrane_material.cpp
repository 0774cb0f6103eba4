#include <gtest/gtest.h>

#include "core/symmetric_eigen.h"
#include "deformation/membrane_material.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;

Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

ElasticMaterial random_material(Random& random) {
  ElasticMaterial material;
  material.stretch_stiffness = {std::exp(random.between(0, 9)), std::exp(random.between(0, 9))};
  material.shear_stiffness = std::exp(random.between(-2, 9));
  material.bend_stiffness = {std::exp(random.between(-12, -5)), std::exp(random.between(-12, -5))};
  material.poisson_ratio = random.between(-0.9, 0.9);
  return material;
}

ElasticMaterial isotropic(double stiffness, double rigidity, double poisson_ratio) {
  ElasticMaterial material;
  material.stretch_stiffness = {stiffness, stiffness};
  material.shear_stiffness = stiffness / (2 * (1 + poisson_ratio));
  material.bend_stiffness = {rigidity, rigidity};
  material.poisson_ratio = poisson_ratio;
  return material;
}

// Tension per width over strain of a strip that is pulled along a direction and free at its sides.
double strip_stiffness(const Mat3& tensor, const Vec2& d) {
  const Vec3 stress(d.x() * d.x(), d.y() * d.y(), d.x() * d.y());
  return 1 / stress.dot(tensor.inverse() * stress);
}

TEST(MembraneMaterial, AnIsotropicSheetHasNoAxes) {
  Random random(1);
  for (const double poisson_ratio : {-0.5, 0.0, 0.3, 0.8}) {
    const ElasticMaterial material = isotropic(3000, 2e-5, poisson_ratio);
    const Vec2 warp = direction(random.between(-3, 3));
    const Mat3 membrane = membrane_tensor(material, Vec2(1, 0)),
               bending = bending_tensor(material, Vec2(1, 0));
    EXPECT_LT((membrane_tensor(material, warp) - membrane).norm(), 1e-14 * membrane.norm());
    EXPECT_LT((bending_tensor(material, warp) - bending).norm(), 1e-14 * bending.norm());
  }
}

TEST(MembraneMaterial, AStripAlongWarpOrWeftHasThatStiffness) {
  Random random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const ElasticMaterial material = random_material(random);
    const double angle = random.between(-3, 3);
    const Mat3 membrane = membrane_tensor(material, direction(angle));
    const Mat3 bending = bending_tensor(material, direction(angle));
    for (const int i : {0, 1}) {
      const Vec2 along = direction(angle + i * std::acos(0.0));
      EXPECT_NEAR(strip_stiffness(membrane, along) / material.stretch_stiffness[i], 1, 1e-8);
      EXPECT_NEAR(strip_stiffness(bending, along) / material.bend_stiffness[i], 1, 1e-8);
    }
  }
}

TEST(MembraneMaterial, AStripOnTheBiasYieldsByAllOfTheStiffnesses) {
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const ElasticMaterial material = random_material(random);
    const auto& [warp, weft] = material.stretch_stiffness;
    const double compliance =
        0.25 * (1 / warp + 1 / weft - 2 * material.poisson_ratio / std::sqrt(warp * weft) +
                1 / material.shear_stiffness);
    const double angle = random.between(-3, 3);
    const double measured =
        strip_stiffness(membrane_tensor(material, direction(angle)), direction(angle + std::atan(1.0)));
    EXPECT_NEAR(measured * compliance, 1, 1e-8);
  }
}

TEST(MembraneMaterial, APulledStripNarrowsByPoissonsRatio) {
  ElasticMaterial material = isotropic(1000, 1e-5, 0.3);
  const Vec3 strain = membrane_tensor(material, Vec2(1, 0)).inverse() * Vec3(1, 0, 0);
  EXPECT_NEAR(strain.y() / strain.x(), -0.3, 1e-14);
}

TEST(MembraneMaterial, PureShearMeetsTheShearStiffnessAlone) {
  Random random(4);
  const ElasticMaterial material = random_material(random);
  const Vec3 stress = membrane_tensor(material, Vec2(1, 0)) * Vec3(0, 0, 1);
  EXPECT_LT((stress - Vec3(0, 0, material.shear_stiffness)).norm(), 1e-13 * material.shear_stiffness);
}

std::array<Vec2, 3> random_directions(Random& random) {
  const double first = random.between(0, 3), second = first + random.between(0.1, 1.4);
  return {direction(first), direction(second), direction(second + random.between(0.1, 1.4))};
}

Mat3 sum_of_bars(const BarSplit& split, const std::array<Vec2, 3>& directions) {
  Mat3 sum = Mat3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec2& d = directions[i];
    const Vec3 strain(d.x() * d.x(), d.y() * d.y(), d.x() * d.y());
    sum += split.bars[i] * strain * strain.transpose();
  }
  return sum;
}

TEST(BarSplit, BarsAndRestAreTheWholeAndTheRestIsPositiveDefinite) {
  Random random(5);
  for (int trial = 0; trial < 500; ++trial) {
    const Mat3 tensor = membrane_tensor(random_material(random), direction(random.between(-3, 3)));
    const std::array<Vec2, 3> directions = random_directions(random);
    const BarSplit split = split_into_bars(tensor, directions);
    EXPECT_LT((sum_of_bars(split, directions) + split.rest - tensor).norm(), 1e-12 * tensor.norm());
    EXPECT_GT(symmetric_eigen(split.rest - 0.019 * tensor).values.minCoeff(), 0);
    for (const double bar : split.bars) EXPECT_GT(bar, 0);
  }
}

// Bars along warp and weft are independent; the diagonal one overlaps with each by the root of its shear's
// share.
double share_along_axes(const std::array<double, 2>& stretch, double shear, double angle) {
  ElasticMaterial material;
  material.stretch_stiffness = stretch;
  material.shear_stiffness = shear;
  const double right = std::acos(0.0);
  const BarSplit split =
      split_into_bars(membrane_tensor(material, direction(angle)),
                      {direction(angle), direction(angle + right), direction(angle + right / 2)});
  EXPECT_NEAR(split.bars[0] / stretch[0], split.bars[1] / stretch[1], 1e-9);
  return split.bars[0] / stretch[0];
}

TEST(BarSplit, BarsAlongAFabricCarryMostOfItsStretch) {
  for (const double angle : {0.0, 0.4, 2.0}) {
    EXPECT_GT(share_along_axes({4000, 2500}, 25, angle), 0.85);
    const double diagonal = 1 / (1.0 / 4000 + 1.0 / 2500 + 1.0 / 600);
    const double overlap = std::sqrt(diagonal / 4000 + diagonal / 2500);
    EXPECT_NEAR(share_along_axes({4000, 2500}, 600, angle), 0.98 / (1 + overlap), 1e-9);
  }
}

}  // namespace
}  // namespace drape
