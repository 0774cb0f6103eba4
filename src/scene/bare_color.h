#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace drape {

// A colour that is a value of a text of YAML and has no quotes, so that it begins a comment.
struct BareColor {
  int line = 1;  // both count from 1
  int column = 1;
  std::string text;
};

// The last one of the first `lines` lines.
std::optional<BareColor> last_bare_color(std::string_view text, int lines);

}  // namespace drape
