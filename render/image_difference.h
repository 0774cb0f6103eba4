#pragma once

#include "render/image.h"

namespace drape::render {

// How far two images of equal size are apart, channel by channel, in steps of 1/255.
struct ImageDifference {
  int largest = 0;
  double mean = 0;        // over all channels
  double share_over = 0;  // the share of pixels with a channel that differs by more than the tolerance
};
ImageDifference compare_images(const Image& a, const Image& b, int tolerance);

// Black where equal, through blue and red to yellow at `full_scale` and more.
Image heat_map(const Image& a, const Image& b, int full_scale);

}  // namespace drape::render
