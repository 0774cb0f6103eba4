#include "app/mesh_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "core/error.h"
#include "mesh/mesh_file.h"

namespace drape::app {
namespace fs = std::filesystem;

static bool is_mesh_file(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".obj" || ending == ".ply";
}

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

static bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

static bool is_pattern(const fs::path& path) {
  return path.filename().string().find_first_of("#*%") != std::string::npos && !fs::exists(path);
}

bool names_meshes(const std::vector<std::string>& inputs) {
  const fs::path first = inputs.front();
  if (is_folder(first)) return !fs::exists(first / "run.json");
  return is_mesh_file(first) || is_pattern(first);
}

// "%04d" as '%': one or more digits.
static std::string simplified(std::string pattern) {
  for (std::size_t begin = pattern.find('%'); begin != std::string::npos;
       begin = pattern.find('%', begin + 1)) {
    std::size_t end = begin + 1;
    while (end < pattern.size() && is_digit(pattern[end])) ++end;
    if (end < pattern.size() && pattern[end] == 'd') pattern.erase(begin + 1, end - begin);
  }
  return pattern;
}

static bool matches(std::string_view pattern, std::string_view name) {
  if (pattern.empty()) return name.empty();
  const std::string_view rest = pattern.substr(1);
  if (pattern.front() == '*')
    return matches(rest, name) || (!name.empty() && matches(pattern, name.substr(1)));
  if (name.empty()) return false;
  const std::string_view name_rest = name.substr(1);
  if (pattern.front() == '#') return is_digit(name.front()) && matches(rest, name_rest);
  if (pattern.front() == '%')
    return is_digit(name.front()) && (matches(rest, name_rest) || matches(pattern, name_rest));
  return pattern.front() == name.front() && matches(rest, name_rest);
}

// Numbers by their values, other letters as they are: frame_9 comes before frame_10.
static bool comes_before(const fs::path& a, const fs::path& b) {
  const auto key = [](const std::string& name) {
    std::vector<std::pair<std::size_t, std::string>> parts;  // a number's length, and its digits
    for (std::size_t i = 0; i < name.size();) {
      std::size_t end = i;
      while (end < name.size() && is_digit(name[end])) ++end;
      if (end == i) {
        parts.emplace_back(0, std::string(1, name[i++]));
        continue;
      }
      const std::size_t first = std::min(name.find_first_not_of('0', i), end - 1);
      parts.emplace_back(end - first, name.substr(first, end - first));
      i = end;
    }
    return parts;
  };
  const auto key_a = key(a.filename().string()), key_b = key(b.filename().string());
  return key_a != key_b ? key_a < key_b : a < b;
}

static std::vector<fs::path> files_in(const fs::path& folder, const std::string& pattern) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error))
    if (is_mesh_file(entry.path()) && matches(pattern, entry.path().filename().string()))
      files.push_back(folder / entry.path().filename());
  if (error) throw FileError(folder.string(), "cannot be read: " + error.message());
  std::sort(files.begin(), files.end(), comes_before);
  return files;
}

static std::vector<fs::path> files_of(const fs::path& input) {
  if (is_folder(input)) {
    auto files = files_in(input, "*");
    if (files.empty())
      throw FileError(input.string(),
                      "holds no OBJ or PLY files, and no run.json of a run: name a scene, the "
                      "folder of a run, or files of meshes");
    return files;
  }
  if (!is_pattern(input)) return {input};
  auto files = files_in(input.parent_path(), simplified(input.filename().string()));
  if (files.empty())
    throw FileError(input.string(), "no OBJ or PLY file fits this pattern (# is a digit, * anything)");
  return files;
}

static bool is_rest_file(const fs::path& path) { return is_mesh_file(path) && path.stem() == "rest"; }

static std::optional<fs::path> take_rest_file(std::vector<fs::path>& files) {
  const auto rest = std::find_if(files.begin(), files.end(), is_rest_file);
  if (rest == files.end() || files.size() == 1) return std::nullopt;
  const fs::path found = *rest;
  files.erase(rest);
  return found;
}

// Whether it has the faces at rest, and after them others that share no point with them.
static bool has_colliders(const PolygonSoup& rest, const PolygonSoup& soup) {
  const auto begins_with = [](const std::vector<int>& all, const std::vector<int>& first) {
    return all.size() > first.size() && std::equal(first.begin(), first.end(), all.begin());
  };
  if (soup.points.size() < rest.points.size()) return false;
  if (!begins_with(soup.polygon_ends, rest.polygon_ends)) return false;
  if (!begins_with(soup.corner_points, rest.corner_points)) return false;
  const int first = static_cast<int>(rest.points.size());
  return std::all_of(soup.corner_points.begin() + static_cast<std::ptrdiff_t>(rest.corner_points.size()),
                     soup.corner_points.end(), [&](int corner) { return corner >= first; });
}

static bool fits(const PolygonSoup& rest, const PolygonSoup& soup) {
  return have_same_faces(soup, rest) || has_colliders(rest, soup);
}

// Nobody has named it: where it is of something else, or no mesh, it has no say.
static bool is_rest_of(const fs::path& rest, const fs::path& frame) {
  std::error_code ignored;
  if (!fs::is_regular_file(rest, ignored)) return false;
  const PolygonSoup soup = read_polygons(frame);
  try {
    return fits(read_polygons(rest), soup);
  } catch (const InputError&) {
    return false;
  }
}

// Where frames are named, by a pattern or one by one, the rest shape that lies with them is seldom named too.
static fs::path find_rest_file(std::vector<fs::path>& files, const std::string& named) {
  const std::optional<fs::path> among = take_rest_file(files);
  if (!named.empty()) return named;
  if (among) return *among;
  const fs::path& first = files.front();
  const fs::path beside = first.parent_path() / ("rest" + first.extension().string());
  return is_rest_of(beside, first) ? beside : first;
}

MeshSequence open_mesh_sequence(const std::vector<std::string>& inputs, const std::string& rest_file) {
  MeshSequence sequence;
  for (const std::string& input : inputs) {
    const auto files = files_of(input);
    sequence.files.insert(sequence.files.end(), files.begin(), files.end());
  }
  sequence.rest_file = find_rest_file(sequence.files, rest_file);
  sequence.rest = read_polygons(sequence.rest_file);
  return sequence;
}

static void check_same_faces(const MeshSequence& sequence, const fs::path& file, const PolygonSoup& soup) {
  const PolygonSoup& rest = sequence.rest;
  if (fits(rest, soup)) return;
  const bool same_size =
      soup.points.size() == rest.points.size() && soup.polygon_ends.size() == rest.polygon_ends.size();
  const std::string what =
      same_size ? fmt::format("the corners of its faces are not those of {}", sequence.rest_file.string())
                : fmt::format("has {}, but {} has {}", size_text(soup), sequence.rest_file.string(),
                              size_text(rest));
  throw InputError(
      {{file.string(), 0, 0,
        what + ": the files of a sequence need the same faces in the same order; name a rest shape "
               "of these faces with --rest, or verify each file alone"}},
      3);
}

static std::vector<int> take_after(std::vector<int>& numbers, std::size_t count, std::size_t offset) {
  std::vector<int> taken;
  for (std::size_t i = count; i < numbers.size(); ++i) taken.push_back(numbers[i] - static_cast<int>(offset));
  numbers.resize(count);
  return taken;
}

// Leaves of the polygons what there is at rest.
static PolygonSoup take_colliders(const PolygonSoup& rest, PolygonSoup& soup) {
  const std::size_t points = rest.points.size(), corners = rest.corner_points.size();
  PolygonSoup colliders;
  colliders.points.assign(soup.points.begin() + static_cast<std::ptrdiff_t>(points), soup.points.end());
  soup.points.resize(points);
  colliders.corner_points = take_after(soup.corner_points, corners, points);
  colliders.polygon_ends = take_after(soup.polygon_ends, rest.polygon_ends.size(), corners);
  return colliders;
}

static std::vector<Triangle> triangles_between(const std::vector<int>& vertices, const PolygonSoup& soup) {
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : cut_into_fans(soup.corner_points, soup.polygon_ends)) {
    const Triangle triangle{vertices[a], vertices[b], vertices[c]};
    if (has_three_corners(triangle)) triangles.push_back(triangle);
  }
  return triangles;
}

MeshFrame read_mesh_frame(const MeshSequence& sequence, const fs::path& file) {
  PolygonSoup soup = read_polygons(file);
  check_same_faces(sequence, file, soup);
  PolygonSoup colliders = take_colliders(sequence.rest, soup);
  MeshFrame frame{sequence.rest.points, {}, {}};
  frame.surface.triangles = triangles_between(first_equal_points(sequence.rest.points, soup.points), soup);
  frame.surface.positions = std::move(soup.points);
  frame.colliders.triangles = triangles_between(first_equal_points(colliders.points), colliders);
  frame.colliders.positions = std::move(colliders.points);
  return frame;
}

}  // namespace drape::app
