#pragma once

#include <optional>
#include <string_view>

#include "render/view.h"

namespace drape {

// "#rrggbb" or "#rgb" in hexadecimal digits; nothing where the text is neither.
std::optional<render::Color> parse_color(std::string_view text);

}  // namespace drape
