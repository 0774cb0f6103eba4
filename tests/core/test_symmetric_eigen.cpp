#include <gtest/gtest.h>

#include <random>

#include "core/symmetric_eigen.h"

namespace drape {
namespace {

Mat3 random_symmetric(std::mt19937& random, double scale) {
  std::uniform_real_distribution<double> value(-scale, scale);
  Mat3 matrix;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j) matrix(i, j) = matrix(j, i) = value(random);
  return matrix;
}

void expect_eigen(const Mat3& matrix) {
  const SymmetricEigen eigen = symmetric_eigen(matrix);
  const double size = matrix.norm();
  const Mat3 again = eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose();
  EXPECT_LE((again - matrix).norm(), 1e-14 * size) << matrix;
  EXPECT_LE((eigen.vectors.transpose() * eigen.vectors - Mat3::Identity()).norm(), 1e-14) << matrix;
}

TEST(SymmetricEigen, ValuesAndVectorsMakeTheMatrixAgain) {
  std::mt19937 random(7);
  for (const double scale : {1e-12, 1.0, 1e9})
    for (int i = 0; i < 200; ++i) expect_eigen(random_symmetric(random, scale));
}

TEST(SymmetricEigen, EqualAndMissingValues) {
  expect_eigen(Mat3::Zero());
  expect_eigen(Mat3::Identity());
  expect_eigen(Mat3::Ones());
  expect_eigen(Vec3(1, 1e-9, 1e-18).asDiagonal());
}

TEST(SymmetricEigen, KnownValues) {
  Mat3 matrix;
  matrix << 2, -1, 0, -1, 2, -1, 0, -1, 2;
  Vec3 values = symmetric_eigen(matrix).values;
  std::sort(values.begin(), values.end());
  EXPECT_NEAR(values[0], 2 - std::sqrt(2), 4e-15);
  EXPECT_NEAR(values[1], 2, 4e-15);
  EXPECT_NEAR(values[2], 2 + std::sqrt(2), 4e-15);
}

}  // namespace
}  // namespace drape
