#include "scene/bare_color.h"

#include <algorithm>

#include "scene/color.h"

namespace drape {
namespace {

bool is_one_of(char c, std::string_view all) { return all.find(c) != all.npos; }

// As far as it may be one.
std::string_view color_text(std::string_view text, std::size_t begin) {
  return text.substr(begin, text.find_first_of(" \t\r\n,]}", begin) - begin);
}

// Follows a text as far as quotes, comments and brackets go. Blocks of text (`|`) are not told apart.
class BracketScan {
 public:
  explicit BracketScan(std::string_view text) : text_(text) {}

  // Where the colour begins.
  std::optional<std::size_t> find_color() {
    while (at_ < text_.size() && !is_broken_) advance();
    return color_;
  }

 private:
  void advance() {
    const char c = text_[at_];
    if (c == '#' && begins_comment()) return take_comment();
    if (is_one_of(c, "\"'") && begins_value()) return skip_quote(c);
    if (is_one_of(c, "[{") && (begins_value() || !open_.empty())) open_ += c;
    if (is_one_of(c, "]}") && !open_.empty()) close(c);
    if (!is_one_of(c, " \t\r")) last_ = c;
    ++at_;
  }

  // Within a word it does not.
  bool begins_comment() const { return at_ == 0 || is_one_of(text_[at_ - 1], " \t\r\n,[]{}\"'"); }
  bool begins_value() const { return is_one_of(last_, "\n:,[{-?"); }

  void take_comment() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const bool is_value = !open_.empty() && is_one_of(last_, ":,[");
    if (is_value && parse_color(color_text(text_, at_))) {
      color_ = at_;
      depth_ = open_.size();
    }
    at_ = end;
  }

  // A quote stands for itself after a backslash or, where it is single, after another.
  void skip_quote(char quote) {
    const std::string_view escaped = quote == '"' ? "\\" : "''";
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_.substr(at_).starts_with(escaped))
        ++at_;
      else if (text_[at_] == quote)
        break;
    }
    last_ = quote;
    ++at_;
  }

  // The parser reads no further than a bracket that closes another.
  void close(char c) {
    is_broken_ = (c == ']') != (open_.back() == '[');
    if (is_broken_) return;
    open_.pop_back();
    if (open_.size() < depth_) color_.reset();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string open_;  // the brackets
  char last_ = '\n';  // that is no blank
  bool is_broken_ = false;
  std::optional<std::size_t> color_;
  std::size_t depth_ = 0;  // of the colour, in brackets
};

}  // namespace

std::optional<BareColor> open_bare_color(std::string_view text) {
  const std::optional<std::size_t> at = BracketScan(text).find_color();
  if (!at) return std::nullopt;
  const std::string_view before = text.substr(0, *at);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t column = *at - (before.rfind('\n') + 1) + 1;
  return BareColor{static_cast<int>(line), static_cast<int>(column), std::string(color_text(text, *at))};
}

}  // namespace drape
