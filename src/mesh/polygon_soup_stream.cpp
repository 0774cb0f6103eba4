#include "mesh/polygon_soup_stream.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "mesh/limits.h"

namespace drape {

template <typename Item>
static void write_run(const std::vector<Item>& items, const ByteSink& write) {
  const std::uint64_t count = items.size();
  write({reinterpret_cast<const char*>(&count), sizeof count});
  write({reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item)});
}

void write_bytes(const SoupInShapes& in_shapes, const ByteSink& write) {
  const PolygonSoup& soup = in_shapes.soup;
  write_run(soup.points, write);
  write_run(soup.uvs, write);
  write_run(soup.corner_points, write);
  write_run(soup.corner_uvs, write);
  write_run(soup.polygon_ends, write);
  write_run(std::vector<std::uint64_t>{in_shapes.shapes.size()}, write);
  for (const std::vector<Vec3>& shape : in_shapes.shapes) write_run(shape, write);
}

template <typename Item>
static bool take(std::string_view& bytes, std::size_t most, std::vector<Item>& items) {
  std::uint64_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  if (count > most || count > bytes.size() / sizeof(Item)) return false;
  items.resize(count);
  if (count > 0) std::memcpy(static_cast<void*>(items.data()), bytes.data(), count * sizeof(Item));
  bytes.remove_prefix(count * sizeof(Item));
  return true;
}

static bool all_under(const std::vector<int>& indices, std::size_t count) {
  return std::all_of(indices.begin(), indices.end(),
                     [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < count; });
}

template <typename Vectors>
static bool all_usable(const Vectors& vectors) {
  return std::all_of(vectors.begin(), vectors.end(), [](const auto& vector) {
    return std::all_of(vector.begin(), vector.end(), is_usable_coordinate);
  });
}

static bool has_whole_polygons(const PolygonSoup& soup) {
  std::int64_t begin = 0;
  for (const int end : soup.polygon_ends) {
    if (end < begin + 3) return false;
    begin = end;
  }
  return static_cast<std::size_t>(begin) == soup.corner_points.size();
}

static bool take_soup(std::string_view& bytes, PolygonSoup& soup) {
  const bool complete = take(bytes, most_points, soup.points) && take(bytes, most_corners, soup.uvs) &&
                        take(bytes, most_corners, soup.corner_points) &&
                        take(bytes, most_corners, soup.corner_uvs) &&
                        take(bytes, most_corners, soup.polygon_ends);
  if (!complete || !all_usable(soup.points) || !all_usable(soup.uvs)) return false;
  if (!soup.corner_uvs.empty() && soup.corner_uvs.size() != soup.corner_points.size()) return false;
  if (!all_under(soup.corner_points, soup.points.size())) return false;
  return all_under(soup.corner_uvs, soup.uvs.size()) && has_whole_polygons(soup);
}

std::optional<SoupInShapes> soup_from_bytes(std::string_view bytes) {
  SoupInShapes result;
  std::vector<std::uint64_t> count;
  if (!take_soup(bytes, result.soup) || !take(bytes, 1, count) || count.size() != 1) return std::nullopt;
  for (std::uint64_t i = 0; i < count[0]; ++i) {
    std::vector<Vec3> shape;
    if (!take(bytes, most_points, shape) || shape.size() != result.soup.points.size()) return std::nullopt;
    if (!all_usable(shape)) return std::nullopt;
    result.shapes.push_back(std::move(shape));
  }
  return bytes.empty() ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace drape
