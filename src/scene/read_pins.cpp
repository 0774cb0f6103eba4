#include "scene/read_pins.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "scene/read_motion.h"
#include "scene/read_vertices.h"
#include "scene/section_values.h"
#include "scene/suggestion.h"

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
  const auto complain_of_flat = [&](const Node& at) {
    pin.problems->add(
        at.place, fmt::format("{} names {}, along which the shape is flat before it is placed: leave it out",
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
    if (bounds.lowest[axis] == bounds.highest[axis]) return complain_of_flat(item);
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

std::vector<int> read_sorted_vertices(const Section& pin, const ClothInput& input) {
  std::vector<int> vertices = read_vertices(pin, static_cast<int>(input.mesh.positions.size()));
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

void read_follow(const Section& pin, const std::vector<std::string_view>& colliders,
                 std::optional<int>& collider) {
  const Node* node = find_value(pin, "follow");
  if (node == nullptr) return;
  const std::string path = path_of(pin, "follow");
  if (has(pin, "animate"))
    pin.problems->add(node->place, fmt::format("{} has both follow and animate: give one", pin.path));
  std::string name;
  read_text(pin, "follow", name);
  const auto found = std::find(colliders.begin(), colliders.end(), name);
  if (found != colliders.end()) {
    collider = static_cast<int>(found - colliders.begin());
  } else if (!name.empty()) {
    const std::string hint =
        colliders.empty() ? "; the scene has none" : suggestion(name, colliders, "colliders");
    pin.problems->add(node->place, fmt::format("{}: no collider is named {}{}", path, quote(name), hint));
  }
}

void read_times(const Section& pin, double fps, PinInput& result) {
  int from = 0, until = 0;
  read_number(pin, "from", from);
  read_number(pin, "until", until);
  result.from = from / fps;
  if (until == 0) return;
  result.until = until / fps;
  if (until <= from)
    pin.problems->add(find_value(pin, "until")->place,
                      fmt::format("{} must be a frame after the one of from, {}, but is {}",
                                  path_of(pin, "until"), from, until));
}

PinInput read_pin(const Section& pin, const ClothInput& input, const std::vector<std::string_view>& colliders,
                  double fps) {
  PinInput result;
  const std::string_view how = exactly_one(pin, "choice of vertices", {"corner", "box", "vertices"});
  if (how == "corner") result.vertices = read_corner(pin, input);
  if (how == "box") result.vertices = read_box(pin, input);
  if (how == "vertices") result.vertices = read_sorted_vertices(pin, input);
  if (has(pin, "animate")) read_animation(pin, fps, result.motion.emplace());
  read_follow(pin, colliders, result.collider);
  read_times(pin, fps, result);
  return result;
}

bool hold_together(const PinInput& a, const PinInput& b) {
  return (!a.until || b.from < *a.until) && (!b.until || a.from < *b.until);
}

// Of each vertex, the pins before that hold it.
using Holders = std::map<int, std::vector<std::size_t>>;

void check_holders(const std::vector<Section>& sections, const std::vector<PinInput>& pins,
                   Holders& holders) {
  const std::size_t last = pins.size() - 1;
  for (const int vertex : pins[last].vertices) {
    for (const std::size_t other : holders[vertex])
      if (hold_together(pins[last], pins[other]))
        return sections[last].problems->add(sections[last].place,
                                            fmt::format("{} holds vertex {}, which {} holds already",
                                                        sections[last].path, vertex, sections[other].path));
    holders[vertex].push_back(last);
  }
}

}  // namespace

std::vector<PinInput> read_pins(const Section& cloth, const ClothInput& input,
                                const std::vector<std::string_view>& colliders, double fps) {
  std::vector<PinInput> pins;
  Holders holders;
  const std::vector<Section> sections = open_list(cloth, "pins");
  for (const Section& section : sections) {
    pins.push_back(read_pin(section, input, colliders, fps));
    check_holders(sections, pins, holders);
  }
  return pins;
}

}  // namespace drape
