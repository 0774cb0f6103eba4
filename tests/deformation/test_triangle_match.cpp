#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "deformation/triangle_match.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;
using Corners = std::array<Vec3, 3>;
using Masses = std::array<double, 3>;

Vec3 centre_of(const Corners& x, const Masses& m) {
  return (m[0] * x[0] + m[1] * x[1] + m[2] * x[2]) / (m[0] + m[1] + m[2]);
}

Corners displacements(const Corners& rest, const Masses& masses, const Corners& x) {
  return match_displacements(match_constants(rest, masses), x[0], x[1], x[2]);
}

// The same by the textbook: polar decomposition of sum m p q^T through its singular values.
Corners displacements_by_svd(const Corners& rest, const Masses& masses, const Corners& x) {
  const Vec3 rest_centre = centre_of(rest, masses), centre = centre_of(x, masses);
  Mat3 a = Mat3::Zero();
  for (int i = 0; i < 3; ++i) a += masses[i] * (x[i] - centre) * (rest[i] - rest_centre).transpose();
  const Eigen::JacobiSVD<Mat3> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  const Mat3 rotation = svd.matrixU() * Vec3(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
  Corners result;
  for (int i = 0; i < 3; ++i) result[i] = rotation * (rest[i] - rest_centre) + centre - x[i];
  return result;
}

double shape(const Corners& x) {
  const Vec3 p = x[1] - x[0], q = x[2] - x[0];
  return p.cross(q).norm() / (p.squaredNorm() + q.squaredNorm());
}

Corners random_corners(Random& random, double size = 1) {
  return {random.vector(size), random.vector(size), random.vector(size)};
}

Corners random_triangle(Random& random) {
  Corners x = random_corners(random);
  while (shape(x) < 0.05) x = random_corners(random);
  return x;
}

Masses random_three(Random& random) {
  return {random.between(0.1, 10), random.between(0.1, 10), random.between(0.1, 10)};
}

double misfit(const Masses& masses, const Corners& d) {
  return masses[0] * d[0].squaredNorm() + masses[1] * d[1].squaredNorm() + masses[2] * d[2].squaredNorm();
}

TEST(TriangleMatch, EqualsAPolarDecomposition) {
  Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const Corners rest = random_triangle(random), x = random_triangle(random);
    const Masses masses = random_three(random);
    const Corners got = displacements(rest, masses, x), wanted = displacements_by_svd(rest, masses, x);
    for (int i = 0; i < 3; ++i) ASSERT_LT((got[i] - wanted[i]).norm(), 1e-12) << "trial " << trial;
  }
}

TEST(TriangleMatch, RestShapeMovedRigidlyStays) {
  Random random(2);
  for (int trial = 0; trial < 500; ++trial) {
    const Corners rest = random_triangle(random);
    const Mat3 rotation = random.rotation();
    const Vec3 shift = random.vector(3);
    Corners x;
    for (int i = 0; i < 3; ++i) x[i] = rotation * rest[i] + shift;
    for (const Vec3& d : displacements(rest, random_three(random), x)) ASSERT_LT(d.norm(), 1e-13);
  }
}

TEST(TriangleMatch, AMirroredTriangleIsTheSameTriangleTurnedOver) {
  Random random(3);
  const Corners rest = random_triangle(random);
  Corners mirrored = rest;
  for (Vec3& x : mirrored) x.y() = -x.y();
  for (const Vec3& d : displacements(rest, {1, 2, 3}, mirrored)) EXPECT_LT(d.norm(), 1e-13);
}

TEST(TriangleMatch, DisplacementsHaveNoLinearMomentum) {
  Random random(4);
  for (int trial = 0; trial < 500; ++trial) {
    const Masses m = random_three(random);
    const Corners d = displacements(random_triangle(random), m, random_corners(random));
    ASSERT_LT((m[0] * d[0] + m[1] * d[1] + m[2] * d[2]).norm(), 1e-13);
  }
}

TEST(TriangleMatch, DisplacementsHaveNoAngularMomentumAboutTheCurrentPoints) {
  Random random(5);
  for (int trial = 0; trial < 500; ++trial) {
    const Masses m = random_three(random);
    const Corners x = random_triangle(random);
    const Corners d = displacements(random_triangle(random), m, x);
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 3; ++i) sum += m[i] * x[i].cross(d[i]);
    ASSERT_LT(sum.norm(), 1e-12);
  }
}

TEST(TriangleMatch, GoalsHaveTheShapeOfTheRestTriangle) {
  Random random(6);
  for (int trial = 0; trial < 200; ++trial) {
    const Corners rest = random_triangle(random), x = random_corners(random);
    const Corners d = displacements(rest, random_three(random), x);
    for (int i = 0; i < 3; ++i) {
      const int k = (i + 1) % 3;
      ASSERT_NEAR((x[i] + d[i] - x[k] - d[k]).norm(), (rest[i] - rest[k]).norm(), 1e-12);
    }
  }
}

// Which side a line of points is on is left open; how well it fits is not.
TEST(TriangleMatch, CollinearPointsFitAsWellAsAnyRotationCan) {
  Random random(7);
  for (int trial = 0; trial < 500; ++trial) {
    const Corners rest = random_triangle(random);
    const Masses masses = random_three(random);
    const Vec3 start = random.vector(), direction = random.vector();
    const Corners x = {start, start + random.between(-1, 1) * direction,
                       start + random.between(-1, 1) * direction};
    const double best = misfit(masses, displacements_by_svd(rest, masses, x));
    ASSERT_NEAR(misfit(masses, displacements(rest, masses, x)), best, 1e-9 * best) << "trial " << trial;
  }
}

TEST(TriangleMatch, PointsAlongAnAxisFitAsWellAsAnyRotationCan) {
  Random random(8);
  for (int axis = 0; axis < 3; ++axis)
    for (const std::array<double, 3>& places :
         {std::array{0.0, 1.0, 2.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}) {
      const Corners rest = random_triangle(random);
      Corners x;
      for (int i = 0; i < 3; ++i) x[i] = places[i] * Vec3::Unit(axis);
      const double best = misfit({1, 1, 1}, displacements_by_svd(rest, {1, 1, 1}, x));
      EXPECT_NEAR(misfit({1, 1, 1}, displacements(rest, {1, 1, 1}, x)), best, 1e-9);
    }
}

TEST(TriangleMatch, ThinTrianglesFitAsWellAsAnyRotationCan) {
  Random random(9);
  for (double height = 1e-3; height > 1e-14; height /= 10) {
    const Corners rest = random_triangle(random);
    const Corners x = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.4, height, 0)};
    const double best = misfit({1, 2, 1}, displacements_by_svd(rest, {1, 2, 1}, x));
    EXPECT_NEAR(misfit({1, 2, 1}, displacements(rest, {1, 2, 1}, x)), best, 1e-9) << height;
  }
}

TEST(TriangleMatch, CoincidentPointsStay) {
  const Corners rest = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  for (const Vec3& d : displacements(rest, {1, 1, 1}, {Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)}))
    EXPECT_EQ(d, Vec3(0, 0, 0));
}

TEST(TriangleMatch, ExtremeSizesGiveFiniteAndBoundedDisplacements) {
  Random random(10);
  for (const double size : {1e-12, 1e-6, 1e3, 1e6}) {
    const Corners rest = random_triangle(random), x = random_corners(random, size);
    for (const Vec3& d : displacements(rest, {1, 1, 1}, x)) {
      ASSERT_TRUE(d.allFinite());
      EXPECT_LT(d.norm(), 4 * (1 + size));
    }
  }
}

TEST(TriangleMatch, ANormalStandsAcrossItsDirectionAndHasUnitLength) {
  Random random(11);
  for (const Vec3& direction : {random.vector(), Vec3(1, 0, 0), Vec3(0, -2, 0), Vec3(0, 0, 3)}) {
    EXPECT_NEAR(any_normal(direction).norm(), 1, 1e-15);
    EXPECT_NEAR(any_normal(direction).dot(direction), 0, 1e-15);
  }
  EXPECT_EQ(any_normal(Vec3(0, 0, 0)).norm(), 1);
}

}  // namespace
}  // namespace drape
