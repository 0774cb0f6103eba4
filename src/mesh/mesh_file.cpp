#include "mesh/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/error.h"
#include "core/file.h"
#include "mesh/import_process.h"
#include "mesh/limits.h"
#include "mesh/mesh_text.h"
#include "mesh/obj_reader.h"
#include "mesh/ply_reader.h"

namespace drape {
namespace fs = std::filesystem;

// Pipes and devices may have no end.
static void check_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw FileError(path.string(), "cannot be read: " + error.message());
  if (!fs::is_regular_file(status)) throw FileError(path.string(), "is not a regular file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > most_file_bytes)
    refuse(path, fmt::format("the file has {} bytes; the most is {}", size, most_file_bytes));
}

static std::string lower_case_ending(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

PolygonSoup read_polygons(const fs::path& path) {
  check_file(path);
  const std::string ending = lower_case_ending(path);
  if (ending == ".obj") return read_obj(read_file(path), path);
  if (ending == ".ply") return read_ply(read_file(path), path);
  return import_in_child(path, std::nullopt).soup;
}

SoupInShapes read_clip(const fs::path& path, const ClipRequest& clip) {
  check_file(path);
  const std::string ending = lower_case_ending(path);
  if (ending == ".obj" || ending == ".ply")
    throw UnknownClip("has no animation: files of its format hold none; use .glb, .fbx or .dae");
  return import_in_child(path, clip);
}

TriangleMesh read_mesh(const fs::path& path) { return weld(read_polygons(path)); }

static void append_face(const TriangleMesh& mesh, std::size_t t, std::string& text) {
  text += 'f';
  for (int k = 0; k < 3; ++k) {
    fmt::format_to(std::back_inserter(text), " {}", mesh.triangles[t][k] + 1);
    if (!mesh.uv_triangles.empty())
      fmt::format_to(std::back_inserter(text), "/{}", mesh.uv_triangles[t][k] + 1);
  }
  text += '\n';
}

void write_obj(const fs::path& path, const TriangleMesh& mesh) {
  std::string text;
  const auto end = std::back_inserter(text);
  for (const Vec3& p : mesh.positions) fmt::format_to(end, "v {:.9g} {:.9g} {:.9g}\n", p.x(), p.y(), p.z());
  if (!mesh.uv_triangles.empty())
    for (const Vec2& uv : mesh.uvs) fmt::format_to(end, "vt {:.9g} {:.9g}\n", uv.x(), uv.y());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) append_face(mesh, t, text);
  write_file(path, text);
}

}  // namespace drape
