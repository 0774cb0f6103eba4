#include "svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape::bench {
namespace {

constexpr double width = 720, height = 440, left = 80, right = 20, top = 40, bottom = 60;

// From values of an axis to places in the picture.
struct Scale {
  double low, high;  // values at the ends
  double from, to;   // places of the ends
  bool logarithmic;
  std::vector<double> ticks;

  double place(double value) const {
    const double share =
        logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return from + share * (to - from);
  }
};

// 1, 2 or 5 times a power of ten, so that about six ticks cover the range.
double tick_distance(double range) {
  const double power = std::pow(10, std::floor(std::log10(range / 6)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power * 6 >= range) return factor * power;
  return 10 * power;
}

Scale linear_scale(double high, double from, double to) {
  const double distance = tick_distance(high);
  const int count = static_cast<int>(std::ceil(high / distance - 1e-9));
  Scale scale{0, count * distance, from, to, false, {}};
  for (int i = 0; i <= count; ++i) scale.ticks.push_back(i * distance);
  return scale;
}

Scale logarithmic_scale(double low, double high, double from, double to) {
  const int first = static_cast<int>(std::floor(std::log10(low) + 1e-9));
  const int last = std::max(first + 1, static_cast<int>(std::ceil(std::log10(high) - 1e-9)));
  Scale scale{std::pow(10, first), std::pow(10, last), from, to, true, {}};
  for (int power = first; power <= last; ++power) scale.ticks.push_back(std::pow(10, power));
  return scale;
}

Scale scale_of(const Plot& plot, std::size_t coordinate, double from, double to) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const Series& series : plot.series)
    for (const auto& point : series.points) {
      low = std::min(low, point[coordinate]);
      high = std::max(high, point[coordinate]);
    }
  const bool logarithmic = coordinate == 0 ? plot.x.logarithmic : plot.y.logarithmic;
  return logarithmic ? logarithmic_scale(low, high, from, to) : linear_scale(high, from, to);
}

std::string line(double x1, double y1, double x2, double y2, const char* color) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1,
                     y1, x2, y2, color);
}

std::string text(double x, double y, const char* anchor, const std::string& words, const char* more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                     words);
}

std::string axes(const Plot& plot, const Scale& x, const Scale& y) {
  std::string svg;
  for (const double tick : x.ticks) {
    svg += line(x.place(tick), top, x.place(tick), height - bottom, "#ddd");
    svg += text(x.place(tick), height - bottom + 18, "middle", fmt::format("{:.6g}", tick));
  }
  for (const double tick : y.ticks) {
    svg += line(left, y.place(tick), width - right, y.place(tick), "#ddd");
    svg += text(left - 8, y.place(tick) + 4, "end", fmt::format("{:.6g}", tick));
  }
  svg += line(left, height - bottom, width - right, height - bottom, "#000");
  svg += line(left, top, left, height - bottom, "#000");
  svg += text((left + width - right) / 2, height - 16, "middle", plot.x.label);
  const std::string turned = fmt::format(" transform=\"rotate(-90 18 {:.1f})\"", (top + height - bottom) / 2);
  return svg + text(18, (top + height - bottom) / 2, "middle", plot.y.label, turned.c_str());
}

std::string curve(const Series& series, const Scale& x, const Scale& y) {
  std::string path, marks;
  for (const auto& point : series.points) {
    path += fmt::format("{:.1f},{:.1f} ", x.place(point[0]), y.place(point[1]));
    marks += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n", x.place(point[0]),
                         y.place(point[1]), series.color);
  }
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n", path,
                     series.color) +
         marks;
}

std::string legend(const Plot& plot) {
  std::string svg;
  double y = top + 16;
  for (const Series& series : plot.series) {
    svg += line(left + 14, y - 4, left + 44, y - 4, series.color.c_str());
    svg += text(left + 52, y, "start", series.name);
    y += 18;
  }
  return svg;
}

}  // namespace

std::string to_svg(const Plot& plot) {
  const Scale x = scale_of(plot, 0, left, width - right), y = scale_of(plot, 1, height - bottom, top);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      width, height);
  svg += text(width / 2, 24, "middle", plot.title) + axes(plot, x, y);
  for (const Series& series : plot.series) svg += curve(series, x, y);
  return svg + legend(plot) + "</svg>\n";
}

}  // namespace drape::bench
