#include "app/frame_range.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>

#include "core/error.h"

namespace drape::app {

[[noreturn]] static void refuse(const std::string& message) { throw InputError({{"", 0, 0, message}}); }

// A number that fills the whole text, or nothing.
static std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// The text before and after the first `separator`; the second is empty where there is none.
static std::pair<std::string_view, std::string_view> split(std::string_view text, char separator) {
  const std::size_t at = text.find(separator);
  if (at == std::string_view::npos) return {text, {}};
  return {text.substr(0, at), text.substr(at + 1)};
}

namespace {
struct Range {
  int first;
  int last;
  int stride;
};
}  // namespace

static std::optional<Range> parse_range(std::string_view text) {
  const bool has_stride = text.find('x') != std::string_view::npos;
  const auto [ends, stride_text] = split(text, 'x');
  const bool has_last = ends.find('-') != std::string_view::npos;
  const auto [first_text, last_text] = split(ends, '-');
  const auto first = whole_number(first_text);
  const auto last = has_last ? whole_number(last_text) : first;
  const auto stride = has_stride ? whole_number(stride_text) : 1;
  if (!first || !last || !stride || *stride < 1 || *last < *first) return std::nullopt;
  return Range{*first, *last, *stride};
}

static void check_inside(const Range& range, int first, int last) {
  if (range.first >= first && range.last <= last) return;
  const int outside = range.first < first ? range.first : range.last;
  refuse(fmt::format("frame {} is not in the scene, whose frames are {}-{}", outside, first, last));
}

std::vector<int> parse_frames(const std::string& text, int first, int last) {
  std::set<int> frames;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto range = parse_range(std::string_view(text).substr(begin, end - begin));
    if (!range) refuse(fmt::format("'{}' is no list of frames: write 1-100, 1-100x5 or 1,5,9-12", text));
    check_inside(*range, first, last);
    for (std::int64_t frame = range->first; frame <= range->last; frame += range->stride)
      frames.insert(static_cast<int>(frame));
    begin = end + 1;
  }
  return {frames.begin(), frames.end()};
}

std::vector<int> all_frames(int first, int last) {
  std::vector<int> frames(static_cast<std::size_t>(last - first + 1));
  std::iota(frames.begin(), frames.end(), first);
  return frames;
}

Chunk parse_chunk(const std::string& text) {
  const auto [index_text, count_text] = split(text, '/');
  const auto index = whole_number(index_text);
  const auto count = whole_number(count_text);
  if (!index || !count || *index < 1 || *index > *count) {
    refuse(fmt::format("'{}' is no chunk: write 2/8 for the second of eight", text));
  }
  return {*index, *count};
}

std::vector<int> frames_of_chunk(const std::vector<int>& frames, const Chunk& chunk) {
  const auto border = [&](int index) {
    return frames.begin() + static_cast<std::ptrdiff_t>(frames.size() * static_cast<std::size_t>(index) /
                                                        static_cast<std::size_t>(chunk.count));
  };
  return {border(chunk.index - 1), border(chunk.index)};
}

std::string resolution_as_yaml(const std::string& text) {
  const auto [width, height] = split(text, 'x');
  if (!whole_number(width) || !whole_number(height)) {
    refuse(fmt::format("'{}' is no resolution: write 1280x720", text));
  }
  return fmt::format("[{}, {}]", width, height);
}

}  // namespace drape::app
