#include "scene/bare_color.h"

#include "scene/color.h"

namespace drape {

// Within a word or a quote, # begins no comment.
static std::size_t find_comment(std::string_view line) {
  std::size_t at = line.find('#');
  while (at != line.npos && at > 0 && std::string_view(" \t,[{").find(line[at - 1]) == line.npos)
    at = line.find('#', at + 1);
  return at;
}

static bool awaits_value(std::string_view before) {
  const std::size_t last = before.find_last_not_of(" \t");
  return last != before.npos && std::string_view(":,[").find(before[last]) != before.npos;
}

static std::optional<BareColor> bare_color_in(std::string_view line, int number) {
  const std::size_t at = find_comment(line);
  if (at == line.npos || !awaits_value(line.substr(0, at))) return std::nullopt;
  const std::string_view comment = line.substr(at);
  const std::string_view word = comment.substr(0, comment.find_first_of(" \t\r,]}"));
  if (!parse_color(word)) return std::nullopt;
  return BareColor{number, static_cast<int>(at) + 1, std::string(word)};
}

std::optional<BareColor> last_bare_color(std::string_view text, int lines) {
  std::optional<BareColor> last;
  for (int number = 1; number <= lines && !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    if (auto found = bare_color_in(text.substr(0, end), number)) last = std::move(found);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  return last;
}

}  // namespace drape
