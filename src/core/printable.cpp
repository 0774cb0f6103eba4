#include "core/printable.h"

#include <algorithm>
#include <array>

namespace drape {

// The lengths, lead bytes and second bytes that RFC 3629 allows: no overlong forms, surrogates or values over
// U+10FFFF.
struct Utf8Form {
  unsigned char first_lead, last_lead, first_second, last_second;
  std::size_t length;
};
static constexpr std::array<Utf8Form, 9> utf8_forms = {{{0x00, 0x7F, 0x00, 0xFF, 1},
                                                        {0xC2, 0xDF, 0x80, 0xBF, 2},
                                                        {0xE0, 0xE0, 0xA0, 0xBF, 3},
                                                        {0xE1, 0xEC, 0x80, 0xBF, 3},
                                                        {0xED, 0xED, 0x80, 0x9F, 3},
                                                        {0xEE, 0xEF, 0x80, 0xBF, 3},
                                                        {0xF0, 0xF0, 0x90, 0xBF, 4},
                                                        {0xF1, 0xF3, 0x80, 0xBF, 4},
                                                        {0xF4, 0xF4, 0x80, 0x8F, 4}}};

static bool fits(std::string_view text, const Utf8Form& form) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (text.size() < form.length || byte(0) < form.first_lead || byte(0) > form.last_lead) return false;
  if (form.length > 1 && (byte(1) < form.first_second || byte(1) > form.last_second)) return false;
  for (std::size_t i = 2; i < form.length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return false;
  return true;
}

std::size_t character_length(std::string_view text) {
  const auto form =
      std::find_if(utf8_forms.begin(), utf8_forms.end(), [&](const auto& f) { return fits(text, f); });
  return form == utf8_forms.end() ? 0 : form->length;
}

// U+0000 to U+001F and U+007F to U+009F.
static bool is_control(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  return character.size() == 1 ? byte(0) < 0x20 || byte(0) == 0x7F
                               : character.size() == 2 && byte(0) == 0xC2 && byte(1) < 0xA0;
}

std::string printable(std::string_view text, std::size_t most_bytes) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    const std::string_view as_shown = length == 0 || is_control(character) ? "?" : character;
    if (shown.size() + as_shown.size() > most_bytes) break;
    shown += as_shown;
    text.remove_prefix(character.size());
  }
  return shown;
}

}  // namespace drape
