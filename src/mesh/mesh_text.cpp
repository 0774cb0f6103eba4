#include "mesh/mesh_text.h"

#include <charconv>

#include "core/error.h"
#include "core/printable.h"

namespace drape {

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

std::optional<Word> WordReader::next_on_line() {
  while (position_ < text_.size() && is_blank(text_[position_])) ++position_;
  const std::size_t begin = position_;
  while (position_ < text_.size() && !is_blank(text_[position_]) && text_[position_] != '\n') ++position_;
  if (position_ == begin) return std::nullopt;
  return Word{text_.substr(begin, position_ - begin), line_, static_cast<int>(begin - line_begin_ + 1)};
}

std::optional<Word> WordReader::next() {
  do {
    if (const auto word = next_on_line()) return word;
  } while (next_line());
  return std::nullopt;
}

bool WordReader::next_line() {
  const std::size_t end = text_.find('\n', position_);
  position_ = end == std::string_view::npos ? text_.size() : end + 1;
  if (position_ == text_.size()) return false;
  line_begin_ = position_;
  ++line_;
  return true;
}

void refuse(const std::filesystem::path& file, const std::string& message) {
  throw InputError({{file.string(), 0, 0, message}}, 3);
}

void refuse(const std::filesystem::path& file, const Word& at, const std::string& message) {
  throw InputError({{file.string(), at.line, at.column, message}}, 3);
}

// from_chars takes no plus sign, and reads no locale.
template <typename Number>
static std::optional<Number> parse(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

std::optional<double> to_number(std::string_view text) { return parse<double>(text); }
std::optional<long long> to_integer(std::string_view text) { return parse<long long>(text); }

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  return "'" + printable(text, longest) + (text.size() > longest ? "..." : "") + "'";
}

}  // namespace drape
