#include "scene/read_seams.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/read_vertices.h"
#include "scene/section_values.h"
#include "scene/suggestion.h"

namespace drape {
namespace {

using Cloths = std::vector<ClothDescription>;

// The index of the cloth that the side names; nothing, and a problem, where none has that name.
std::optional<int> read_cloth(const Section& side, const Cloths& cloths) {
  std::string name;
  read_text(side, "cloth", name);
  if (name.empty()) return std::nullopt;
  std::vector<std::string_view> names;
  for (const ClothDescription& cloth : cloths) names.push_back(cloth.input.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  side.problems->add(find_value(side, "cloth")->place,
                     fmt::format("{}: no cloth is named {}{}", path_of(side, "cloth"), quote(name),
                                 suggestion(name, names, "cloths")));
  return std::nullopt;
}

// Rounding may tell the points of an edge apart.
std::vector<int> farthest_along(const std::vector<Vec3>& points, int axis, double sign) {
  constexpr double rounding = 1e-6;  // m
  double farthest = sign * points.front()[axis];
  for (const Vec3& point : points) farthest = std::max(farthest, sign * point[axis]);
  std::vector<int> vertices;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (sign * points[v][axis] > farthest - rounding) vertices.push_back(static_cast<int>(v));
  const int other = 2 - axis;
  std::stable_sort(vertices.begin(), vertices.end(),
                   [&](int a, int b) { return points[a][other] < points[b][other]; });
  return vertices;
}

std::vector<int> read_edge(const Section& side, const ClothInput& cloth) {
  int edge = -1;  // -x, +x, -z, +z
  read_choice(side, "edge", edge);
  if (edge < 0) return {};
  return farthest_along(cloth.mesh.positions, edge < 2 ? 0 : 2, edge % 2 == 0 ? -1 : 1);
}

std::vector<int> read_side(const Section& side, const ClothInput& cloth) {
  const std::string_view how = exactly_one(side, "choice of vertices", {"edge", "vertices"});
  std::vector<int> vertices;
  if (how == "edge") vertices = read_edge(side, cloth);
  if (how == "vertices") vertices = read_vertices(side, static_cast<int>(cloth.mesh.positions.size()));
  bool reverse = false;
  read_boolean(side, "reverse", reverse);
  if (reverse) std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

void check_pairs(const Section& section, const SeamInput& seam) {
  const auto& [first, second] = seam.vertices;
  const Place& place = find_value(section, "between")->place;
  const std::string path = path_of(section, "between");
  if (first.size() != second.size())
    return section.problems->add(
        place, fmt::format("{} has {} vertices on one side and {} on the other: give as many on both", path,
                           first.size(), second.size()));
  if (seam.cloths[0] != seam.cloths[1]) return;
  for (std::size_t i = 0; i < first.size(); ++i)
    if (first[i] == second[i])
      return section.problems->add(place, fmt::format("{} pairs vertex {} with itself", path, first[i]));
}

void read_sides(const Section& section, const Cloths& cloths, SeamInput& seam) {
  const std::size_t problems_before = section.problems->size();
  const std::vector<Section> sides = open_list(section, "between");
  if (section.problems->size() > problems_before || !has(section, "between")) return;
  if (sides.size() != 2)
    return section.problems->add(
        find_value(section, "between")->place,
        fmt::format("{} must be a list of two sides, not of {}", path_of(section, "between"), sides.size()));
  for (std::size_t i = 0; i < 2; ++i) {
    const auto cloth = read_cloth(sides[i], cloths);
    if (!cloth) continue;
    seam.cloths[i] = *cloth;
    seam.vertices[i] = read_side(sides[i], cloths[*cloth].input);
  }
  if (section.problems->size() == problems_before) check_pairs(section, seam);
}

void read_times(const Section& section, double fps, SeamInput& seam) {
  int from = 0, close = 30;
  read_number(section, "from", from);
  read_number(section, "close", close);
  seam.from = from / fps;
  seam.close = close / fps;
  if (close > from) return;
  const Node* node = find_value(section, has(section, "close") ? "close" : "from");
  section.problems->add(node->place, fmt::format("{} must be a frame after the one of from, {}, but is {}",
                                                 path_of(section, "close"), from, close));
}

}  // namespace

std::vector<SeamInput> read_seams(const Section& scene, const Cloths& cloths, double fps) {
  std::vector<SeamInput> seams;
  for (const Section& section : open_list(scene, "seams")) {
    SeamInput seam{};
    read_sides(section, cloths, seam);
    read_times(section, fps, seam);
    seams.push_back(std::move(seam));
  }
  return seams;
}

}  // namespace drape
