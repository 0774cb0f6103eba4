#include "scene/text_encoding.h"

#include <fmt/format.h>

#include "core/printable.h"

namespace drape {

// The bytes of the character that the text starts with; 0 where it is none that a scene may hold.
static std::size_t text_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const bool is_space = lead == '\t' || lead == '\n' || lead == '\r';
  const bool is_control = (lead < 0x20 && !is_space) || lead == 0x7F;
  return is_control ? 0 : character_length(text);
}

std::optional<EncodingFault> find_encoding_fault(std::string_view text) {
  EncodingFault place;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = text_length(text.substr(i));
    if (length == 0) {
      const auto byte = static_cast<unsigned char>(text[i]);
      place.message = byte < 0x80 ? fmt::format("the control character 0x{:02X} is not text", byte)
                                  : fmt::format("byte 0x{:02X} is not UTF-8", byte);
      return place;
    }
    place.line += text[i] == '\n';
    place.column = text[i] == '\n' ? 1 : place.column + static_cast<int>(length);
    i += length;
  }
  return std::nullopt;
}

}  // namespace drape
