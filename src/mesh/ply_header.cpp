#include "mesh/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace drape {
namespace {

// The words of one line, and where the line stands.
struct HeaderLine {
  const std::filesystem::path& path;
  std::vector<Word> words;

  // A word behind the last one: where it would stand.
  const Word& word(std::size_t i, const char* grammar) const {
    if (i >= words.size()) refuse(path, words.front(), std::string("the line is too short: ") + grammar);
    return words[i];
  }
};

PlyType type_named(const HeaderLine& line, const Word& word) {
  constexpr std::array<std::pair<std::string_view, PlyType>, 16> names = {{
      {"char", PlyType::int8},
      {"uchar", PlyType::uint8},
      {"short", PlyType::int16},
      {"ushort", PlyType::uint16},
      {"int", PlyType::int32},
      {"uint", PlyType::uint32},
      {"float", PlyType::float32},
      {"double", PlyType::float64},
      {"int8", PlyType::int8},
      {"uint8", PlyType::uint8},
      {"int16", PlyType::int16},
      {"uint16", PlyType::uint16},
      {"int32", PlyType::int32},
      {"uint32", PlyType::uint32},
      {"float32", PlyType::float32},
      {"float64", PlyType::float64},
  }};
  for (const auto& [name, type] : names)
    if (word.text == name) return type;
  refuse(line.path, word, in_quotes(word.text) + " is not a type of PLY (float, int, uchar, ...)");
}

PlyFormat read_format(const HeaderLine& line) {
  constexpr auto grammar = "format ascii|binary_little_endian|binary_big_endian 1.0";
  const Word& name = line.word(1, grammar);
  const Word& version = line.word(2, grammar);
  if (version.text != "1.0")
    refuse(line.path, version, in_quotes(version.text) + " is not 1.0, the version of PLY");
  if (name.text == "ascii") return PlyFormat::ascii;
  if (name.text == "binary_little_endian") return PlyFormat::binary_little_endian;
  if (name.text == "binary_big_endian") return PlyFormat::binary_big_endian;
  refuse(line.path, name, in_quotes(name.text) + " is not a format of PLY: " + grammar);
}

PlyElement read_element(const HeaderLine& line, const std::vector<PlyElement>& before) {
  constexpr auto grammar = "element NAME COUNT";
  const std::string name(line.word(1, grammar).text);
  const Word& count_word = line.word(2, grammar);
  const auto count = to_integer(count_word.text);
  if (!count || *count < 0) refuse(line.path, count_word, in_quotes(count_word.text) + " is not a count");
  if (std::any_of(before.begin(), before.end(), [&](const auto& element) { return element.name == name; }))
    refuse(line.path, line.words[1], "element " + in_quotes(name) + " is declared twice");
  return {name, *count, {}};
}

PlyProperty read_property(const HeaderLine& line) {
  constexpr auto grammar = "property TYPE NAME, or property list COUNT_TYPE TYPE NAME";
  if (line.word(1, grammar).text != "list")
    return {std::string(line.word(2, grammar).text), type_named(line, line.words[1]), std::nullopt};
  const PlyType count_type = type_named(line, line.word(2, grammar));
  if (count_type == PlyType::float32 || count_type == PlyType::float64)
    refuse(line.path, line.words[2], "the count of a list must be of an integer type");
  const PlyType type = type_named(line, line.word(3, grammar));
  return {std::string(line.word(4, grammar).text), type, count_type};
}

HeaderLine read_line(WordReader& words, const std::filesystem::path& path) {
  HeaderLine line{path, {}};
  while (const auto word = words.next_on_line()) line.words.push_back(*word);
  return line;
}

bool is_passed_over(const HeaderLine& line) {
  return line.words.empty() || line.words[0].text == "comment" || line.words[0].text == "obj_info";
}

void read_statement(const HeaderLine& line, std::optional<PlyFormat>& format,
                    std::vector<PlyElement>& elements) {
  const Word& keyword = line.words[0];
  if (keyword.text == "format") {
    format = read_format(line);
  } else if (keyword.text == "element") {
    elements.push_back(read_element(line, elements));
  } else if (keyword.text == "property") {
    if (elements.empty()) refuse(line.path, keyword, "a property before the first element");
    elements.back().properties.push_back(read_property(line));
  } else {
    refuse(line.path, keyword,
           in_quotes(keyword.text) +
               " is not a statement of a PLY header (format, element, property, end_header)");
  }
}

}  // namespace

std::size_t byte_size(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      break;
  }
  return 8;
}

PlyHeader read_ply_header(WordReader& words, const std::filesystem::path& path) {
  const HeaderLine magic = read_line(words, path);
  if (magic.words.size() != 1 || magic.words[0].text != "ply")
    refuse(path, Word{{}, 1, 1}, "a PLY file starts with a line 'ply'");

  std::optional<PlyFormat> format;
  std::vector<PlyElement> elements;
  while (words.next_line()) {
    const HeaderLine line = read_line(words, path);
    if (is_passed_over(line)) continue;
    if (line.words[0].text == "end_header") {
      if (!format) refuse(path, line.words[0], "the header has no line 'format ...'");
      words.next_line();
      return {*format, std::move(elements)};
    }
    read_statement(line, format, elements);
  }
  refuse(path, "the file ends before its header does; a line 'end_header' is missing");
}

}  // namespace drape
