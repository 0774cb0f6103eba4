#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace drape {

// A word of a text file and where it stands, counted from 1.
struct Word {
  std::string_view text;
  int line = 0;
  int column = 0;
};

// Walks through the words of a text, line by line. A line ends with LF or CR LF; the last one may end with
// the text.
class WordReader {
 public:
  explicit WordReader(std::string_view text) : text_(text) {}

  std::optional<Word> next_on_line();  // nothing at the line's end
  std::optional<Word> next();          // nothing at the text's end
  bool next_line();                    // skips the rest of the line; false at the text's end
  int line() const { return line_; }
  std::size_t position() const { return position_; }
  std::size_t remaining() const { return text_.size() - position_; }

 private:
  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t line_begin_ = 0;
  int line_ = 1;
};

// Throws InputError with exit status 3. Without a place, the problem is the file as a whole.
[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& message);
[[noreturn]] void refuse(const std::filesystem::path& file, const Word& at, const std::string& message);

// Nothing where the whole of the text is not one number, or it is out of the type's range.
std::optional<double> to_number(std::string_view text);
std::optional<long long> to_integer(std::string_view text);

// For messages: in quotes, shortened, and without what a terminal would obey.
std::string in_quotes(std::string_view text);

}  // namespace drape
