#include <gtest/gtest.h>

#include "deformation/bending_angle.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;

constexpr std::array<int, 4> pair = {2, 3, 0, 1};

std::vector<Vec3> folded_pair(double angle) { return test::equilateral_pair(1, angle).positions; }

double angle_of(const std::vector<Vec3>& x) { return 2 * std::asin(bending_angle(pair, x).half_sine); }

std::vector<Vec3> crooked_pair(Random& random) {
  return test::shaken(folded_pair(random.between(-1.5, 1.5)), 0.2, random);
}

TEST(BendingAngle, IsTheFoldOfTheTwoTriangles) {
  EXPECT_EQ(angle_of(folded_pair(0)), 0);
  const double sign = angle_of(folded_pair(1)) > 0 ? 1 : -1;
  for (const double angle : {1e-12, 1e-6, 0.3, 1.0, 3.0, -1e-12, -0.3, -3.0}) {
    const double half_sine = sign * bending_angle(pair, folded_pair(angle)).half_sine;
    EXPECT_NEAR(half_sine, std::sin(angle / 2), 1e-14 * std::abs(angle));
  }
}

TEST(BendingAngle, TheGradientsAreThoseOfTheAngle) {
  Random random(1);
  constexpr double h = 1e-6;
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<Vec3> x = crooked_pair(random);
    const BendingAngle angle = bending_angle(pair, x);
    for (int i = 0; i < 4; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        std::vector<Vec3> more = x, less = x;
        more[pair[i]][axis] += h;
        less[pair[i]][axis] -= h;
        EXPECT_NEAR(angle.gradients[i][axis], (angle_of(more) - angle_of(less)) / (2 * h), 1e-7);
      }
  }
}

// BMF03, section 4: the bending mode is orthogonal to rigid motion and to in-plane motion.
TEST(BendingAngle, TheGradientsHaveNoPartInRigidNorInPlaneMotion) {
  Random random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<Vec3> x = crooked_pair(random);
    const std::array<Vec3, 4> g = bending_angle(pair, x).gradients;
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    for (int i = 0; i < 4; ++i) {
      force += g[i];
      torque += x[pair[i]].cross(g[i]);
    }
    EXPECT_LT(force.norm(), 1e-13);
    EXPECT_LT(torque.norm(), 1e-13);
    const Vec3 edge = x[1] - x[0];
    for (const int end : {0, 1})
      for (const int across : {0, 1}) EXPECT_LT(std::abs(g[across].dot(x[pair[across]] - x[end])), 1e-14);
    EXPECT_LT(std::abs((g[3] - g[2]).dot(edge)), 1e-13);
  }
}

TEST(BendingAngle, ATriangleThatIsALineHasNeitherAngleNorGradients) {
  std::vector<Vec3> x = folded_pair(1);
  x[2] = 0.3 * x[0] + 0.7 * x[1];
  const BendingAngle angle = bending_angle(pair, x);
  EXPECT_EQ(angle.half_sine, 0);
  for (const Vec3& gradient : angle.gradients) EXPECT_EQ(gradient, Vec3::Zero());
}

}  // namespace
}  // namespace drape
