#include "scene/read_frame_range.h"

#include <fmt/format.h>

#include <array>

namespace drape {

static std::optional<std::array<int, 2>> parse_frames(std::string_view text) {
  const std::size_t dash = text.find('-');
  const bool is_range = dash != std::string_view::npos;
  const auto first = is_range ? parse_quantity(text.substr(0, dash), Quantity::plain) : ParsedNumber{1, {}};
  const auto last = parse_quantity(text.substr(is_range ? dash + 1 : 0), Quantity::plain);
  const auto fits = [](const ParsedNumber& number) {
    return number.mistake.empty() && number.value >= 1 && number.value <= frame_rule.greatest &&
           number.value == static_cast<int>(number.value);
  };
  if (!fits(first) || !fits(last) || first.value > last.value) return std::nullopt;
  return std::array{static_cast<int>(first.value), static_cast<int>(last.value)};
}

void read_frame_range(const Section& section, std::string_view name, int& first, int& last) {
  const Node* node = find_value(section, name);
  if (node == nullptr) return;
  const auto frames = node->kind == Node::Kind::scalar ? parse_frames(node->text) : std::nullopt;
  if (!frames)
    return section.problems->add_cause(
        node->place, fmt::format("{} must be `first-last` or a count, of frames from 1 to {}, not {}",
                                 path_of(section, name), frame_rule.greatest, describe(*node)));
  first = (*frames)[0];
  last = (*frames)[1];
}

}  // namespace drape
