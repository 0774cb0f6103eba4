#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace drape {

// A colour that is a value within brackets of YAML and has no quotes, so that it begins a comment.
struct BareColor {
  int line = 1;  // both count from 1
  int column = 1;
  std::string text;
};

// The last one whose bracket is still open at the end of the text, which may be where a parser gave up.
std::optional<BareColor> open_bare_color(std::string_view text);

}  // namespace drape
