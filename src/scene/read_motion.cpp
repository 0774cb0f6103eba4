#include "scene/read_motion.h"

#include <fmt/format.h>

#include "scene/section_values.h"

namespace drape {

void read_place(const Section& owner, RigidMotion& motion) {
  const Section place = open_section(owner, "place");
  read_numbers(place, "at", motion.at);
  read_numbers(place, "rotate", motion.rotate);
}

namespace {

struct Keyframe {
  double frame;
  std::vector<double> values;
};

std::optional<Keyframe> read_keyframe(const Node& node, const Key& key, const std::string& path,
                                      ProblemList& problems) {
  const bool is_point = key.kind == KeyKind::point_keyframes;
  if (node.kind != Node::Kind::sequence || node.items.size() != 2) {
    problems.add(node.place, fmt::format("{} must be a keyframe, {}, not {}", path,
                                         is_point ? "[frame, [x, y, z]]" : "[frame, angle]", describe(node)));
    return std::nullopt;
  }
  const auto frame = number_in(node.items[0], frame_rule, path + "[0]", problems);
  std::vector<double> values;
  if (is_point)
    values = numbers_in(node.items[1], key.number, 3, path + "[1]", problems);
  else if (const auto value = number_in(node.items[1], key.number, path + "[1]", problems))
    values = {*value};
  if (!frame || values.empty()) return std::nullopt;
  return Keyframe{*frame, std::move(values)};
}

std::vector<Keyframe> read_keyframes(const Section& section, std::string_view name) {
  const Node* node = find_value(section, name);
  if (node == nullptr) return {};
  const std::string path = path_of(section, name);
  if (node->kind != Node::Kind::sequence || node->items.empty()) {
    section.problems->add(node->place,
                          fmt::format("{} must be a list of keyframes, not {}", path, describe(*node)));
    return {};
  }
  std::vector<Keyframe> keyframes;
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const Node& item = node->items[i];
    auto keyframe =
        read_keyframe(item, *find_key(section.keys, name), fmt::format("{}[{}]", path, i), *section.problems);
    if (!keyframe) continue;
    if (!keyframes.empty() && keyframe->frame <= keyframes.back().frame)
      section.problems->add(item.place, fmt::format("{}[{}]: frame {} must come after frame {}", path, i,
                                                    keyframe->frame, keyframes.back().frame));
    keyframes.push_back(std::move(*keyframe));
  }
  return keyframes;
}

}  // namespace

void read_animation(const Section& owner, double fps, RigidMotion& motion) {
  const Section animate = open_section(owner, "animate");
  for (const Keyframe& keyframe : read_keyframes(animate, "translate"))
    for (std::size_t axis = 0; axis < 3; ++axis)
      motion.translate[axis].emplace_back(keyframe.frame / fps, keyframe.values[axis]);
  constexpr std::string_view turns[] = {"rotate_x", "rotate_y", "rotate_z"};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const Keyframe& keyframe : read_keyframes(animate, turns[axis]))
      motion.turn[axis].emplace_back(keyframe.frame / fps, keyframe.values[0]);
}

}  // namespace drape
