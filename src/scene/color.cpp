#include "scene/color.h"

#include <charconv>

namespace drape {

// Two hexadecimal digits as a part of 255.
static std::optional<float> parse_part(char high, char low) {
  const char digits[] = {high, low};
  int value = 0;
  const auto [end, status] = std::from_chars(digits, digits + 2, value, 16);
  if (status != std::errc() || end != digits + 2 || high == '-') return std::nullopt;
  return static_cast<float>(value) / 255.0f;
}

std::optional<render::Color> parse_color(std::string_view text) {
  if (!text.starts_with('#') || (text.size() != 4 && text.size() != 7)) return std::nullopt;
  const bool is_short = text.size() == 4;
  render::Color color;
  for (int i = 0; i < 3; ++i) {
    const std::size_t at = is_short ? 1 + i : 1 + 2 * i;
    const auto part = parse_part(text[at], text[at + (is_short ? 0 : 1)]);
    if (!part) return std::nullopt;
    color[i] = *part;
  }
  return color;
}

}  // namespace drape
