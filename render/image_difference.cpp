#include "render/image_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace drape::render {

static void check_same_size(const Image& a, const Image& b) {
  if (a.width == b.width && a.height == b.height && a.rgb.size() == b.rgb.size()) return;
  throw std::invalid_argument("only images of equal size can be compared");
}

// The largest difference of the three channels of a pixel.
static int pixel_difference(const Image& a, const Image& b, std::size_t pixel) {
  int largest = 0;
  for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
    largest = std::max(largest, std::abs(a.rgb[i] - b.rgb[i]));
  return largest;
}

static double mean_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(a.rgb[i] - b.rgb[i]);
  return sum / static_cast<double>(std::max<std::size_t>(a.rgb.size(), 1));
}

ImageDifference compare_images(const Image& a, const Image& b, int tolerance) {
  check_same_size(a, b);
  const std::size_t pixels = a.rgb.size() / 3;
  ImageDifference difference;
  std::size_t over = 0;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const int here = pixel_difference(a, b, pixel);
    difference.largest = std::max(difference.largest, here);
    if (here > tolerance) ++over;
  }
  difference.mean = mean_difference(a, b);
  difference.share_over = static_cast<double>(over) / static_cast<double>(std::max<std::size_t>(pixels, 1));
  return difference;
}

// Black, blue, red, yellow at 0, 1/3, 2/3, 1 and straight lines between them.
static std::array<std::uint8_t, 3> heat(double share) {
  const auto ramp = [](double x) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0, 1.0)));
  };
  const double third = 3 * std::clamp(share, 0.0, 1.0);
  return {ramp(third - 1), ramp(third - 2), ramp(std::min(third, 2 - third))};
}

Image heat_map(const Image& a, const Image& b, int full_scale) {
  check_same_size(a, b);
  if (full_scale < 1) throw std::invalid_argument("the full scale of a heat map is at least 1");
  Image map{a.width, a.height, std::vector<std::uint8_t>(a.rgb.size())};
  for (std::size_t pixel = 0; pixel < a.rgb.size() / 3; ++pixel) {
    const auto color = heat(static_cast<double>(pixel_difference(a, b, pixel)) / full_scale);
    std::copy(color.begin(), color.end(), map.rgb.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
  }
  return map;
}

}  // namespace drape::render
