#pragma once

#include <array>
#include <string>
#include <vector>

namespace drape::bench {

struct Series {
  std::string name;
  std::string color;
  std::vector<std::array<double, 2>> points;
};

struct Axis {
  std::string label;
  bool logarithmic = false;  // then all values are positive
};

// A line plot with axes, ticks and a legend.
struct Plot {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
};

std::string to_svg(const Plot& plot);

}  // namespace drape::bench
