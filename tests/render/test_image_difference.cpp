#include <gtest/gtest.h>

#include <stdexcept>

#include "render/image_difference.h"

namespace drape::render {
namespace {

Image make_gray(int width, int height, std::uint8_t value) {
  return {width, height, std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width) * height, value)};
}

TEST(ImageDifference, AnImageIsNotFarFromItself) {
  const ImageDifference difference = compare_images(make_gray(4, 3, 90), make_gray(4, 3, 90), 0);
  EXPECT_EQ(difference.largest, 0);
  EXPECT_EQ(difference.mean, 0);
  EXPECT_EQ(difference.share_over, 0);
}

TEST(ImageDifference, OneChannelOfOnePixel) {
  const Image a = make_gray(10, 10, 100);
  Image b = a;
  b.rgb[7] = 106;
  const ImageDifference difference = compare_images(a, b, 1);
  EXPECT_EQ(difference.largest, 6);
  EXPECT_DOUBLE_EQ(difference.mean, 6.0 / 300);
  EXPECT_DOUBLE_EQ(difference.share_over, 1.0 / 100);
}

TEST(ImageDifference, ToleranceIsAllowedItself) {
  EXPECT_EQ(compare_images(make_gray(2, 2, 10), make_gray(2, 2, 12), 2).share_over, 0);
  EXPECT_EQ(compare_images(make_gray(2, 2, 10), make_gray(2, 2, 12), 1).share_over, 1);
}

TEST(ImageDifference, SignDoesNotMatter) {
  EXPECT_EQ(compare_images(make_gray(2, 2, 255), make_gray(2, 2, 0), 0).largest, 255);
  EXPECT_EQ(compare_images(make_gray(2, 2, 0), make_gray(2, 2, 255), 0).largest, 255);
}

TEST(ImageDifference, SizesMustBeEqual) {
  EXPECT_THROW(compare_images(make_gray(2, 3, 0), make_gray(3, 2, 0), 0), std::invalid_argument);
  EXPECT_THROW(heat_map(make_gray(2, 3, 0), make_gray(3, 2, 0), 8), std::invalid_argument);
}

TEST(HeatMap, RunsFromBlackThroughBlueAndRedToYellow) {
  const Image a = make_gray(5, 1, 0);
  Image b = a;
  for (int x = 0; x < 5; ++x) b.rgb[3 * x] = static_cast<std::uint8_t>(3 * x);
  const Image map = heat_map(a, b, 9);
  const std::vector<std::uint8_t> expected = {0, 0, 0, 0, 0, 255, 255, 0, 0, 255, 255, 0, 255, 255, 0};
  EXPECT_EQ(map.rgb, expected);
}

}  // namespace
}  // namespace drape::render
