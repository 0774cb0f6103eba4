#include "scene/text_encoding.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>

namespace drape {

// The lengths, lead bytes and second bytes that RFC 3629 allows: no overlong forms, surrogates or values over
// U+10FFFF.
struct Utf8Form {
  unsigned char first_lead, last_lead, first_second, last_second;
  std::size_t length;
};
static constexpr std::array<Utf8Form, 8> utf8_forms = {{{0xC2, 0xDF, 0x80, 0xBF, 2},
                                                        {0xE0, 0xE0, 0xA0, 0xBF, 3},
                                                        {0xE1, 0xEC, 0x80, 0xBF, 3},
                                                        {0xED, 0xED, 0x80, 0x9F, 3},
                                                        {0xEE, 0xEF, 0x80, 0xBF, 3},
                                                        {0xF0, 0xF0, 0x90, 0xBF, 4},
                                                        {0xF1, 0xF3, 0x80, 0xBF, 4},
                                                        {0xF4, 0xF4, 0x80, 0x8F, 4}}};

static bool fits(std::string_view text, const Utf8Form& form) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < form.first_lead || byte(0) > form.last_lead || text.size() < form.length) return false;
  if (byte(1) < form.first_second || byte(1) > form.last_second) return false;
  for (std::size_t i = 2; i < form.length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return false;
  return true;
}

// The bytes of the character that the text starts with; 0 where it is none.
static std::size_t character_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) {
    const bool is_space = lead == '\t' || lead == '\n' || lead == '\r';
    return (lead >= 0x20 && lead != 0x7F) || is_space ? 1 : 0;
  }
  for (const Utf8Form& form : utf8_forms)
    if (fits(text, form)) return form.length;
  return 0;
}

std::optional<EncodingFault> find_encoding_fault(std::string_view text) {
  EncodingFault place;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text.substr(i));
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
