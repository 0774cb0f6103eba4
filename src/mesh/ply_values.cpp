#include "mesh/ply_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace drape {

PlyValues::PlyValues(std::string_view content, const WordReader& words, PlyFormat format,
                     const std::filesystem::path& path)
    : bytes_(content.substr(words.position())), words_(words), format_(format), path_(path) {}

void PlyValues::set_row(const PlyElement& element, long long row) {
  element_ = &element;
  row_ = row;
}

void PlyValues::refuse_row(const std::string& message) const {
  refuse(path_, last_, fmt::format("{} {} {}", element_->name, row_, message));
}

long long PlyValues::remaining() const {
  return static_cast<long long>(format_ == PlyFormat::ascii ? words_.remaining() + 1 : bytes_.size());
}

// A word has at least one letter and one blank or line end, but at the file's end.
long long PlyValues::least_size(PlyType type) const {
  return format_ == PlyFormat::ascii ? 2 : static_cast<long long>(byte_size(type));
}

double PlyValues::next(PlyType type) { return format_ == PlyFormat::ascii ? next_word() : next_bytes(type); }

double PlyValues::next_word() {
  const auto word = words_.next();
  if (!word) refuse_row("is not whole: the file ends in it");
  last_ = *word;
  const auto number = to_number(word->text);
  if (!number) refuse_row("has a value that is not a number: " + in_quotes(word->text));
  return *number;
}

template <typename Value>
static double value_of(const std::array<char, 8>& bytes) {
  Value value;
  std::memcpy(&value, bytes.data(), sizeof value);
  return static_cast<double>(value);
}

static double value_of(PlyType type, const std::array<char, 8>& bytes) {
  switch (type) {
    case PlyType::int8:
      return value_of<std::int8_t>(bytes);
    case PlyType::uint8:
      return value_of<std::uint8_t>(bytes);
    case PlyType::int16:
      return value_of<std::int16_t>(bytes);
    case PlyType::uint16:
      return value_of<std::uint16_t>(bytes);
    case PlyType::int32:
      return value_of<std::int32_t>(bytes);
    case PlyType::uint32:
      return value_of<std::uint32_t>(bytes);
    case PlyType::float32:
      return value_of<float>(bytes);
    case PlyType::float64:
      break;
  }
  return value_of<double>(bytes);
}

double PlyValues::next_bytes(PlyType type) {
  const std::size_t size = byte_size(type);
  if (bytes_.size() < size) refuse_row("is not whole: the file ends in it");
  std::array<char, 8> value{};
  std::copy_n(bytes_.begin(), size, value.begin());
  bytes_.remove_prefix(size);
  const bool file_is_little = format_ == PlyFormat::binary_little_endian;
  if (file_is_little != (std::endian::native == std::endian::little))
    std::reverse(value.begin(), value.begin() + size);
  return value_of(type, value);
}

long long PlyValues::next_integer(PlyType type, long long most, const char* what) {
  const double value = next(type);
  if (!(value >= 0 && value <= static_cast<double>(most) && value == std::floor(value)))
    refuse_row(fmt::format("names {} {:g}, but they are numbered 0 to {}", what, value, most));
  return static_cast<long long>(value);
}

long long PlyValues::next_list_count(const PlyProperty& list) {
  const double count = next(*list.count_type);
  if (!(count >= 0 && count == std::floor(count)))
    refuse_row(fmt::format("has a list {} of {:g} values", in_quotes(list.name), count));
  if (count > static_cast<double>(remaining() / least_size(list.type)))
    refuse_row(fmt::format("has a list {} of {:g} values, more than are left in the file",
                           in_quotes(list.name), count));
  return static_cast<long long>(count);
}

void PlyValues::check_fits(const PlyElement& element) {
  long long row_size = 0;
  for (const PlyProperty& property : element.properties)
    row_size += least_size(property.count_type.value_or(property.type));
  if (row_size > 0 && element.count > remaining() / row_size)
    refuse(path_, fmt::format("the header promises {} rows of {}, but the file is too short for them",
                              element.count, in_quotes(element.name)));
}

}  // namespace drape
