#include "certificate/orientation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "certificate/whole_numbers.h"

namespace drape {
namespace {

using test::determinant;
using test::to_vector;
using test::Whole;
using test::WholeRandom;

int sign(test::Long value) { return (value > 0) - (value < 0); }

int orientation_of(const Whole& a, const Whole& b, const Whole& c, const Whole& d) {
  return orientation(to_vector(a), to_vector(b), to_vector(c), to_vector(d));
}

// Nearly in one plane: a corner and a whole combination of two edges, moved by a few units.
TEST(Orientation, IsTheSignOfTheDeterminantOfWholeNumbersOf38Bits) {
  WholeRandom random(1);
  const long long largest = 1LL << 34;
  int zeros = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Whole a = random.point(largest), b = random.point(largest), c = random.point(largest);
    const long long s = random.number(5), t = random.number(5);
    Whole d;
    for (int k = 0; k < 3; ++k) d[k] = a[k] + s * (b[k] - a[k]) + t * (c[k] - a[k]);
    d[trial % 3] += random.number(1);
    const int wanted = sign(determinant(a, b, c, d));
    zeros += wanted == 0;
    ASSERT_EQ(orientation_of(a, b, c, d), wanted) << "trial " << trial;
  }
  EXPECT_GT(zeros, 1000);
}

// Differences that a double cannot hold: x of 53 bits and of a few bits next to each other.
TEST(Orientation, IsExactWhereDifferencesRound) {
  WholeRandom random(2);
  const auto mixed = [&](bool large) {
    Whole p = random.point(1 << 10);
    if (large) p[0] = (1LL << 53) - 1 - 2 * std::abs(random.number(1000));
    return p;
  };
  int rounded = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    Whole a = mixed(trial % 2), b = mixed(trial % 3 == 0), c = mixed(false);
    Whole d;
    for (int k = 0; k < 3; ++k) d[k] = b[k] + c[k] - a[k];
    d[1] += random.number(1);
    if (std::abs(d[0]) >= 1LL << 53) continue;
    rounded += to_vector(a).x() - to_vector(d).x() != static_cast<double>(a[0] - d[0]) ||
               static_cast<long long>(to_vector(a).x() - to_vector(d).x()) != a[0] - d[0];
    ASSERT_EQ(orientation_of(a, b, c, d), sign(determinant(a, b, c, d))) << "trial " << trial;
  }
  EXPECT_GT(rounded, 100);
}

// A tenth is no double, and what is left of it decides.
TEST(Orientation, IsExactForDecimalFractions) {
  const Vec3 a(0.1, 0.1, 0.1), b(0.7, 0.7, 0.7), c(0, 1, 0);
  EXPECT_EQ(orientation(a, b, c, {0.4, 0.4, 0.4}), 0);
  EXPECT_NE(orientation(a, b, c, {0.4, 0.4, std::nextafter(0.4, 1)}), 0);
  EXPECT_EQ(orientation(a, b, c, {0.4, 0.4, std::nextafter(0.4, 1)}),
            -orientation(a, b, c, {0.4, 0.4, std::nextafter(0.4, 0)}));
}

TEST(Orientation, ChangesItsSignWithEachExchange) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), above(0.1, 0.1, 1e-30);
  EXPECT_EQ(orientation(a, b, c, above), -1);
  EXPECT_EQ(orientation(b, a, c, above), 1);
  EXPECT_EQ(orientation(a, b, c, -above), 1);
}

TEST(Orientation, InAPlaneTellsTheSideOfALine) {
  const double third = 1.0 / 3;
  const Vec3 a(5, 0, 0), b(5, 2, 2 * third);
  EXPECT_EQ(orientation_without(0, a, b, {9, 1, third}), 0);
  EXPECT_EQ(orientation_without(0, a, b, {9, 1, std::nextafter(third, 1)}), 1);
  EXPECT_EQ(orientation_without(0, a, b, {9, 1, std::nextafter(third, 0)}), -1);
}

// Corners of a long triangle, nearly on one line.
TEST(Orientation, InAPlaneIsTheSignOfTheDeterminantOfWholeNumbersOf52Bits) {
  WholeRandom random(3);
  const Whole above{0, 0, 1};
  int zeros = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    Whole a = random.point(1LL << 48), b = random.point(1LL << 48);
    const long long s = random.number(7);
    Whole c;
    for (int k = 0; k < 3; ++k) c[k] = a[k] + s * (b[k] - a[k]);
    c[trial % 2] += random.number(1);
    a[2] = b[2] = c[2] = 0;
    const int wanted = -sign(determinant(a, b, c, above));
    zeros += wanted == 0;
    ASSERT_EQ(orientation_without(2, to_vector(a), to_vector(b), to_vector(c)), wanted) << "trial " << trial;
  }
  EXPECT_GT(zeros, 1000);
}

TEST(Orientation, ProjectsAlongAnAxisThatLeavesATriangle) {
  EXPECT_EQ(projection_axis({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 2);
  EXPECT_EQ(projection_axis({0, 0, 0}, {0, 1, 0}, {0, 0, 1}), 0);
  EXPECT_EQ(projection_axis({1, 2, 3}, {2, 4, 6}, {3, 6, 9}), -1);
  EXPECT_EQ(projection_axis({1, 2, 3}, {1, 2, 3}, {1, 2, 3}), -1);
}

}  // namespace
}  // namespace drape
