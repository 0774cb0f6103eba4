#include "mesh/obj_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "mesh/limits.h"
#include "mesh/mesh_text.h"

namespace drape {
namespace {

struct ObjReader {
  const std::filesystem::path& path;
  WordReader words;
  PolygonSoup soup;
  std::vector<Word> face_places{};  // the keyword of each face
  bool every_corner_has_uv = true;
};

// Statements about groups, normals, materials, lines and points of a polygon mesh: nothing that Drape needs.
bool is_passed_over(std::string_view keyword) {
  constexpr std::array<std::string_view, 20> keywords = {
      "vn", "vp", "g",     "o",   "s",     "mg",       "usemtl",   "mtllib",     "usemap",    "maplib",
      "l",  "p",  "bevel", "lod", "group", "c_interp", "d_interp", "shadow_obj", "trace_obj", "call"};
  return std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
}

double coordinate(const ObjReader& reader, const Word& word) {
  const auto number = to_number(word.text);
  if (!number) refuse(reader.path, word, in_quotes(word.text) + " is not a number");
  if (!is_usable_coordinate(*number))
    refuse(reader.path, word,
           fmt::format("{} is not a usable coordinate; it must be within +-{:g}", in_quotes(word.text),
                       largest_coordinate));
  return *number;
}

// What follows the third number (a weight, a colour) is passed over.
void read_point(ObjReader& reader, const Word& keyword) {
  if (reader.soup.points.size() == most_points)
    refuse(reader.path, keyword, fmt::format("more than {} points", most_points));
  Vec3 point;
  for (double& x : point) {
    const auto word = reader.words.next_on_line();
    if (!word) refuse(reader.path, keyword, "a point needs three coordinates: v X Y Z");
    x = coordinate(reader, *word);
  }
  reader.soup.points.push_back(point);
}

void read_uv(ObjReader& reader, const Word& keyword) {
  if (reader.soup.uvs.size() == most_corners)
    refuse(reader.path, keyword, fmt::format("more than {} texture coordinates", most_corners));
  const auto u = reader.words.next_on_line();
  if (!u) refuse(reader.path, keyword, "a texture coordinate needs numbers: vt U V");
  const auto v = reader.words.next_on_line();
  reader.soup.uvs.emplace_back(coordinate(reader, *u), v ? coordinate(reader, *v) : 0.0);
}

// Counted from 0. A negative number counts back from the last one before this line. Whether there is such a
// point shows at the file's end: faces may come first.
int to_index(const ObjReader& reader, const Word& corner, std::string_view text, std::size_t count) {
  const auto number = to_integer(text);
  if (!number)
    refuse(reader.path, corner, in_quotes(corner.text) + " is not a corner of a face: use P, P/T or P/T/N");
  if (*number == 0) refuse(reader.path, corner, "a corner has the number 0, but OBJ files count from 1");
  const long long index = *number > 0 ? *number - 1 : static_cast<long long>(count) + *number;
  if (index < 0)
    refuse(reader.path, corner,
           fmt::format("{} counts back further than there are lines before it: {}", *number, count));
  return static_cast<int>(std::min<long long>(index, std::numeric_limits<int>::max()));
}

// P, P/T, P//N or P/T/N.
void read_corner(ObjReader& reader, const Word& corner) {
  const std::string_view text = corner.text;
  const std::size_t slash = text.find('/');
  reader.soup.corner_points.push_back(
      to_index(reader, corner, text.substr(0, slash), reader.soup.points.size()));
  const std::string_view rest = slash == text.npos ? "" : text.substr(slash + 1);
  const std::string_view uv = rest.substr(0, rest.find('/'));
  reader.every_corner_has_uv = reader.every_corner_has_uv && !uv.empty();
  reader.soup.corner_uvs.push_back(uv.empty() ? 0 : to_index(reader, corner, uv, reader.soup.uvs.size()));
}

void read_face(ObjReader& reader, const Word& keyword) {
  const std::size_t begin = reader.soup.corner_points.size();
  while (const auto corner = reader.words.next_on_line()) {
    if (corner->text.front() == '#') break;
    if (reader.soup.corner_points.size() == most_corners)
      refuse(reader.path, *corner, fmt::format("more than {} corners of faces", most_corners));
    read_corner(reader, *corner);
  }
  const std::size_t corners = reader.soup.corner_points.size() - begin;
  if (corners < 3)
    refuse(
        reader.path, keyword,
        fmt::format("face {} has {} corners; it needs at least 3", reader.face_places.size() + 1, corners));
  reader.soup.polygon_ends.push_back(static_cast<int>(reader.soup.corner_points.size()));
  reader.face_places.push_back(keyword);
}

void read_line(ObjReader& reader) {
  const auto keyword = reader.words.next_on_line();
  if (!keyword || keyword->text.front() == '#') return;
  if (keyword->text == "v") return read_point(reader, *keyword);
  if (keyword->text == "vt") return read_uv(reader, *keyword);
  if (keyword->text == "f" || keyword->text == "fo") return read_face(reader, *keyword);
  if (!is_passed_over(keyword->text))
    refuse(reader.path, *keyword,
           in_quotes(keyword->text) + " is not a statement of a polygon mesh (v, vt, vn, f, ...)");
}

void check_range(const ObjReader& reader, const std::vector<int>& corners, std::size_t count,
                 const std::string& what) {
  const auto wrong = std::find_if(corners.begin(), corners.end(),
                                  [&](int i) { return static_cast<std::size_t>(i) >= count; });
  if (wrong == corners.end()) return;
  const auto& ends = reader.soup.polygon_ends;
  const auto face = std::upper_bound(ends.begin(), ends.end(), wrong - corners.begin()) - ends.begin();
  refuse(reader.path, reader.face_places[face],
         fmt::format("face {} names {} {}, but the file has {}", face + 1, what, *wrong + 1LL, count));
}

}  // namespace

PolygonSoup read_obj(std::string_view text, const std::filesystem::path& path) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  ObjReader reader{path, WordReader(text), {}};
  do read_line(reader);
  while (reader.words.next_line());

  if (reader.soup.polygon_ends.empty()) refuse(path, "there are no faces (lines 'f P P P') in this file");
  check_range(reader, reader.soup.corner_points, reader.soup.points.size(), "point");
  if (!reader.every_corner_has_uv) reader.soup.corner_uvs.clear();
  check_range(reader, reader.soup.corner_uvs, reader.soup.uvs.size(), "texture coordinate");
  return std::move(reader.soup);
}

}  // namespace drape
