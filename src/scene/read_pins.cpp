#include "scene/read_pins.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "scene/read_motion.h"
#include "scene/section_values.h"

namespace drape {
namespace {

struct Bounds {
  Vec3 lowest, highest;
};

Bounds bounds_of(const std::vector<Vec3>& points) {
  Bounds bounds{points.front(), points.front()};
  for (const Vec3& point : points) {
    bounds.lowest = bounds.lowest.cwiseMin(point);
    bounds.highest = bounds.highest.cwiseMax(point);
  }
  return bounds;
}

// The corner is one of the shape before it is placed: turning a cloth does not change which corner is meant.
std::vector<int> read_corner(const Section& pin, const ClothInput& input) {
  const Node& node = *find_value(pin, "corner");
  const auto complain = [&](const Node& at) {
    pin.problems->add(at.place, fmt::format("{} must be a list of signs of axes, such as [-x, +z], not {}",
                                            path_of(pin, "corner"), describe(at)));
    return std::vector<int>();
  };
  if (node.kind != Node::Kind::sequence || node.items.empty() || node.items.size() > 3) return complain(node);
  const Bounds bounds = bounds_of(input.mesh.positions);
  Vec3 corner = (bounds.lowest + bounds.highest) / 2;
  for (const Node& item : node.items) {
    const bool is_sign = item.text.size() == 2 && (item.text[0] == '-' || item.text[0] == '+');
    const int axis = is_sign ? item.text[1] - 'x' : -1;
    if (axis < 0 || axis > 2) return complain(item);
    corner[axis] = item.text[0] == '-' ? bounds.lowest[axis] : bounds.highest[axis];
  }
  const auto& points = input.mesh.positions;
  const auto nearest = std::min_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
    return (a - corner).squaredNorm() < (b - corner).squaredNorm();
  });
  return {static_cast<int>(nearest - points.begin())};
}

std::vector<int> read_box(const Section& pin, const ClothInput& input) {
  const Section box = open_section(pin, "box");
  const std::size_t problems_before = pin.problems->size();
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  read_numbers(box, "from", from);
  read_numbers(box, "to", to);
  if (!has(box, "from") || !has(box, "to") || pin.problems->size() > problems_before) return {};
  const Vec3 lowest = from.cwiseMin(to), highest = from.cwiseMax(to);
  std::vector<int> vertices;
  for (std::size_t i = 0; i < input.start_positions.size(); ++i) {
    const Vec3& point = input.start_positions[i];
    if ((point.array() >= lowest.array()).all() && (point.array() <= highest.array()).all())
      vertices.push_back(static_cast<int>(i));
  }
  if (vertices.empty()) {
    const Bounds start = bounds_of(input.start_positions);
    pin.problems->add(
        box.place, fmt::format("{} holds no vertex; at its start the cloth fills [{:.4g}, {:.4g}, {:.4g}] to "
                               "[{:.4g}, {:.4g}, {:.4g}]",
                               box.path, start.lowest.x(), start.lowest.y(), start.lowest.z(),
                               start.highest.x(), start.highest.y(), start.highest.z()));
  }
  return vertices;
}

std::vector<int> read_vertices(const Section& pin, const ClothInput& input) {
  const Node& node = *find_value(pin, "vertices");
  const std::string path = path_of(pin, "vertices");
  if (node.kind != Node::Kind::sequence || node.items.empty()) {
    pin.problems->add(node.place, fmt::format("{} must be a list of numbers of vertices, not {}", path,
                                              node.items.empty() ? "empty" : describe(node)));
    return {};
  }
  const NumberRule rule{Quantity::plain, 0, static_cast<double>(input.mesh.positions.size()) - 1, true};
  std::vector<int> vertices;
  for (std::size_t i = 0; i < node.items.size(); ++i)
    if (const auto vertex = number_in(node.items[i], rule, fmt::format("{}[{}]", path, i), *pin.problems))
      vertices.push_back(static_cast<int>(*vertex));
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

PinInput read_pin(const Section& pin, const ClothInput& input, double fps) {
  PinInput result;
  const std::string_view how = exactly_one(pin, "choice of vertices", {"corner", "box", "vertices"});
  if (how == "corner") result.vertices = read_corner(pin, input);
  if (how == "box") result.vertices = read_box(pin, input);
  if (how == "vertices") result.vertices = read_vertices(pin, input);
  if (has(pin, "animate")) read_animation(pin, fps, result.motion.emplace());
  if (has(pin, "until")) {
    int frame = 1;
    read_number(pin, "until", frame);
    result.until = frame / fps;
  }
  return result;
}

}  // namespace

std::vector<PinInput> read_pins(const Section& cloth, const ClothInput& input, double fps) {
  std::vector<PinInput> pins;
  std::map<int, std::string> holder;  // of a vertex: the pin's path
  for (const Section& section : open_list(cloth, "pins")) {
    PinInput pin = read_pin(section, input, fps);
    for (const int vertex : pin.vertices) {
      const auto [first, is_new] = holder.emplace(vertex, section.path);
      if (is_new) continue;
      section.problems->add(section.place, fmt::format("{} holds vertex {}, which {} holds already",
                                                       section.path, vertex, first->second));
      break;
    }
    pins.push_back(std::move(pin));
  }
  return pins;
}

}  // namespace drape
