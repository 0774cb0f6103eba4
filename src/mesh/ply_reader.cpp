#include "mesh/ply_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mesh/limits.h"
#include "mesh/ply_values.h"

namespace drape {
namespace {

constexpr int no_slot = -1;
constexpr int slots = 5;  // x, y, z, u, v

int slot_of(const PlyProperty& property) {
  constexpr std::array<std::pair<std::string_view, int>, 11> names = {{{"x", 0},
                                                                       {"y", 1},
                                                                       {"z", 2},
                                                                       {"u", 3},
                                                                       {"s", 3},
                                                                       {"texture_u", 3},
                                                                       {"texture_s", 3},
                                                                       {"v", 4},
                                                                       {"t", 4},
                                                                       {"texture_v", 4},
                                                                       {"texture_t", 4}}};
  if (property.count_type) return no_slot;
  for (const auto& [name, slot] : names)
    if (property.name == name) return slot;
  return no_slot;
}

bool has_slot(const PlyElement& element, int slot) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [&](const PlyProperty& property) { return slot_of(property) == slot; });
}

void skip(PlyValues& values, const PlyProperty& property) {
  const long long count = property.count_type ? values.next_list_count(property) : 1;
  for (long long i = 0; i < count; ++i) values.next(property.type);
}

void skip(PlyValues& values, const PlyElement& element) {
  if (element.properties.empty()) return;
  for (long long row = 0; row < element.count; ++row) {
    values.set_row(element, row);
    for (const PlyProperty& property : element.properties) skip(values, property);
  }
}

double coordinate(PlyValues& values, PlyType type) {
  const double x = values.next(type);
  if (!is_usable_coordinate(x))
    values.refuse_row(
        fmt::format("has the coordinate {:g}; it must be within +-{:g}", x, largest_coordinate));
  return x;
}

void read_points(PlyValues& values, const PlyElement& element, PolygonSoup& soup) {
  const bool has_uvs = has_slot(element, 3) && has_slot(element, 4);
  for (long long row = 0; row < element.count; ++row) {
    values.set_row(element, row);
    std::array<double, slots> point{};
    for (const PlyProperty& property : element.properties) {
      const int slot = slot_of(property);
      if (slot == no_slot)
        skip(values, property);
      else
        point[slot] = coordinate(values, property.type);
    }
    soup.points.emplace_back(point[0], point[1], point[2]);
    if (has_uvs) soup.uvs.emplace_back(point[3], point[4]);
  }
}

bool is_corner_list(const PlyProperty& property) {
  return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool is_uv_list(const PlyProperty& property) { return property.count_type && property.name == "texcoord"; }

struct Face {
  std::vector<int> corners;
  std::vector<double> uvs;  // two for each corner, or none
};

void read_corners(PlyValues& values, const PlyProperty& property, long long points,
                  std::vector<int>& corners) {
  const long long count = values.next_list_count(property);
  if (count < 3) values.refuse_row(fmt::format("has {} corners; it needs at least 3", count));
  corners.clear();
  for (long long i = 0; i < count; ++i)
    corners.push_back(static_cast<int>(values.next_integer(property.type, points - 1, "point")));
}

void read_uvs(PlyValues& values, const PlyProperty& property, std::vector<double>& uvs) {
  const long long count = values.next_list_count(property);
  uvs.clear();
  for (long long i = 0; i < count; ++i) uvs.push_back(coordinate(values, property.type));
}

void append(const PlyValues& values, const Face& face, bool has_uvs, PolygonSoup& soup) {
  if (soup.corner_points.size() + face.corners.size() > most_corners)
    values.refuse_row(fmt::format("makes more than {} corners", most_corners));
  soup.corner_points.insert(soup.corner_points.end(), face.corners.begin(), face.corners.end());
  soup.polygon_ends.push_back(static_cast<int>(soup.corner_points.size()));
  if (!has_uvs) return;
  if (face.uvs.size() != 2 * face.corners.size())
    values.refuse_row(fmt::format("has {} values of texcoord for {} corners; it needs two for each",
                                  face.uvs.size(), face.corners.size()));
  for (std::size_t i = 0; i < face.uvs.size(); i += 2) {
    soup.corner_uvs.push_back(static_cast<int>(soup.uvs.size()));
    soup.uvs.emplace_back(face.uvs[i], face.uvs[i + 1]);
  }
}

void read_faces(PlyValues& values, const PlyElement& element, long long points, PolygonSoup& soup) {
  const bool has_uvs = std::any_of(element.properties.begin(), element.properties.end(), is_uv_list);
  Face face;
  for (long long row = 0; row < element.count; ++row) {
    values.set_row(element, row);
    for (const PlyProperty& property : element.properties) {
      if (is_corner_list(property))
        read_corners(values, property, points, face.corners);
      else if (is_uv_list(property))
        read_uvs(values, property, face.uvs);
      else
        skip(values, property);
    }
    append(values, face, has_uvs, soup);
  }
}

const PlyElement& element_named(const PlyHeader& header, std::string_view name,
                                const std::filesystem::path& path) {
  const auto found = std::find_if(header.elements.begin(), header.elements.end(),
                                  [&](const PlyElement& element) { return element.name == name; });
  if (found == header.elements.end() || found->count == 0)
    refuse(path, fmt::format("the file has no elements {}, which a surface needs", in_quotes(name)));
  return *found;
}

void check_header(const PlyHeader& header, const std::filesystem::path& path) {
  const PlyElement& points = element_named(header, "vertex", path);
  for (int slot = 0; slot < 3; ++slot)
    if (!has_slot(points, slot)) refuse(path, fmt::format("the points have no property '{}'", "xyz"[slot]));
  if (points.count > static_cast<long long>(most_points))
    refuse(path, fmt::format("the file has {} points; the most is {}", points.count, most_points));

  const PlyElement& faces = element_named(header, "face", path);
  if (std::none_of(faces.properties.begin(), faces.properties.end(), is_corner_list))
    refuse(path, "the faces have no list 'vertex_indices'");
}

}  // namespace

PolygonSoup read_ply(std::string_view content, const std::filesystem::path& path) {
  WordReader words(content);
  const PlyHeader header = read_ply_header(words, path);
  check_header(header, path);
  const long long points = element_named(header, "vertex", path).count;
  PlyValues values(content, words, header.format, path);
  PolygonSoup soup;
  for (const PlyElement& element : header.elements) {
    values.check_fits(element);
    if (element.name == "vertex")
      read_points(values, element, soup);
    else if (element.name == "face")
      read_faces(values, element, points, soup);
    else
      skip(values, element);
  }
  if (soup.corner_uvs.empty() && !soup.uvs.empty()) soup.corner_uvs = soup.corner_points;
  return soup;
}

}  // namespace drape
