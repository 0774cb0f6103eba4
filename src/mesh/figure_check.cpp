#include "mesh/figure_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mesh/mesh_text.h"

namespace drape {
namespace {

constexpr double least_sum = 0.9, greatest_sum = 1.1;  // files round, and what is unset is far off

bool is_about_one(double x) { return x >= least_sum && x <= greatest_sum; }  // false for NaN

bool all_finite(const Vec3& value) { return value.allFinite(); }
bool all_finite(const Quaternion& value) { return value.coeffs().allFinite(); }

template <typename Value>
void check_timed(const TimedValues<Value>& timed, const std::string& node) {
  const auto finite = [](double time) { return std::isfinite(time); };
  if (!std::all_of(timed.times.begin(), timed.times.end(), finite) ||
      !std::is_sorted(timed.times.begin(), timed.times.end()))
    throw std::runtime_error(
        fmt::format("the times of the keys of its node {} do not rise", in_quotes(node)));
  for (const Value& value : timed.values)
    if (!all_finite(value))
      throw std::runtime_error(fmt::format("a key of its node {} is not a number", in_quotes(node)));
}

void check_turns(const TimedValues<Quaternion>& turns, const std::string& node) {
  for (const Quaternion& turn : turns.values)
    if (!is_about_one(turn.norm()))
      throw std::runtime_error(fmt::format(
          "a key of its node {} is no rotation: its quaternion has length {:.3g}, not 1; write the "
          "keys as floats",
          in_quotes(node), turn.norm()));
}

void check_motion(const NodeMotion& motion, const std::string& node) {
  check_timed(motion.place, node);
  check_timed(motion.turn, node);
  check_timed(motion.scale, node);
  check_turns(motion.turn, node);
}

void check_shares(const FigureSurface& surface, const std::string& node) {
  std::vector<double> sums(surface.points.size(), 0);
  std::vector<char> is_held(surface.points.size(), false);
  for (const Bone& bone : surface.bones)
    for (const auto& [point, share] : bone.shares) {
      sums[point] += share;
      is_held[point] = true;
    }
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (is_held[i] && !is_about_one(sums[i]))
      throw std::runtime_error(fmt::format(
          "the weights of bones for point {} of its node {} sum up to {:.3g}, not 1: write the weights "
          "as floats, normalised",
          i, in_quotes(node), sums[i]));
}

}  // namespace

void check_figure(const Figure& figure) {
  for (const FigureNode& node : figure.nodes)
    if (node.motion >= 0) check_motion(figure.motions[node.motion], node.name);
  for (const FigureSurface& surface : figure.surfaces) check_shares(surface, figure.nodes[surface.node].name);
}

}  // namespace drape
