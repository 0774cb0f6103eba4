#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/pass_sequence.h"

namespace drape::render {
namespace {

constexpr float two_pi = 2 * std::numbers::pi_v<float>;

class PassSequence : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Passes, PassSequence, testing::Values(1, 2, 3, 4, 7, 16, 64, 100));

TEST_P(PassSequence, StaysInItsDomains) {
  for (int pass = 0; pass < GetParam(); ++pass) {
    const PassSample sample = sample_pass(pass, GetParam());
    EXPECT_LE(sample.pixel_offset.cwiseAbs().maxCoeff(), 1.0f);
    for (const Vec2f& place : sample.sun_disc) EXPECT_LE(place.norm(), 1.0f);
    EXPECT_GE(sample.jitter_phase, 0.0f);
    EXPECT_LT(sample.jitter_phase, 1.0f);
    for (const SkySample& sky : sample.sky) EXPECT_NEAR(sky.direction.norm(), 1, 1e-5);
  }
}

TEST_P(PassSequence, OnlyTheLastDirectionIsBelowTheHorizon) {
  for (int pass = 0; pass < GetParam(); ++pass) {
    const PassSample sample = sample_pass(pass, GetParam());
    for (int i = 0; i + 1 < sky_directions; ++i) EXPECT_GT(sample.sky[i].direction.y(), 0);
    EXPECT_LT(sample.sky[sky_directions - 1].direction.y(), 0);
  }
}

// Under a uniform sky the light on a surface that faces up must not depend on the number of passes: pi.
TEST_P(PassSequence, HalfOfAUniformSkyGivesPi) {
  double solid_angle = 0;
  double irradiance = 0;
  for (int pass = 0; pass < GetParam(); ++pass) {
    for (const SkySample& sky : sample_pass(pass, GetParam()).sky) {
      solid_angle += sky.solid_angle;
      irradiance += sky.solid_angle * std::max(0.0f, sky.direction.y());
    }
  }
  EXPECT_NEAR(solid_angle / GetParam(), 2 * two_pi, 1e-3);
  EXPECT_NEAR(irradiance / GetParam(), two_pi / 2, 1e-3);
}

TEST(PassSequenceOfMany, IsCentred) {
  Vec2f offset = Vec2f::Zero();
  Vec2f disc = Vec2f::Zero();
  Vec3f above = Vec3f::Zero();
  for (int pass = 0; pass < 64; ++pass) {
    const PassSample sample = sample_pass(pass, 64);
    offset += sample.pixel_offset / 64;
    for (const Vec2f& place : sample.sun_disc) disc += place / (64 * sun_places);
    for (int i = 0; i + 1 < sky_directions; ++i)
      above += sample.sky[i].direction / (64 * (sky_directions - 1));
  }
  EXPECT_LT(offset.norm(), 0.01f);
  EXPECT_LT(disc.norm(), 0.02f);
  EXPECT_LT((above - Vec3f(0, 0.5f, 0)).norm(), 0.01f);
}

}  // namespace
}  // namespace drape::render
