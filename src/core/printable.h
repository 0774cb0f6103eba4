#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace drape {

// The bytes of the character of UTF-8 (RFC 3629) that a text starts with; 0 where there is none.
std::size_t character_length(std::string_view text);

// For messages: what a terminal shows and does not obey. Control characters and bytes that are not UTF-8
// become '?', and what does not fit into so many bytes is left out, whole characters at a time.
std::string printable(std::string_view text, std::size_t most_bytes);

}  // namespace drape
