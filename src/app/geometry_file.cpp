#include "app/geometry_file.h"

#include <fmt/format.h>

#include <bit>
#include <iterator>

namespace drape::app {

static_assert(std::endian::native == std::endian::little, "to_ply copies numbers as they lie in memory");

namespace {

// Where the numbers of a part begin: OBJ counts points and texture coordinates through the whole file,
// from 1.
struct Offsets {
  int point = 1;
  int uv = 1;
};

}  // namespace

static void add_face(std::string& text, const TriangleMesh& mesh, std::size_t triangle,
                     const Offsets& offsets) {
  text += 'f';
  for (std::size_t k = 0; k < 3; ++k) {
    fmt::format_to(std::back_inserter(text), " {}", mesh.triangles[triangle][k] + offsets.point);
    if (!mesh.uvs.empty()) {
      fmt::format_to(std::back_inserter(text), "/{}", mesh.uv_triangles[triangle][k] + offsets.uv);
    }
  }
  text += '\n';
}

// A name ends at the first blank for some readers.
static std::string one_word(std::string name) {
  for (char& letter : name) {
    if (letter == ' ' || letter == '\n' || letter == '\t') letter = '_';
  }
  return name;
}

std::string to_obj(const std::vector<GeometryPart>& parts) {
  std::string text;
  Offsets offsets;
  for (const GeometryPart& part : parts) {
    fmt::format_to(std::back_inserter(text), "o {}\n", one_word(part.name));
    for (const Vec3f& p : part.positions) {
      fmt::format_to(std::back_inserter(text), "v {} {} {}\n", p.x(), p.y(), p.z());
    }
    for (const Vec2& uv : part.mesh->uvs)
      fmt::format_to(std::back_inserter(text), "vt {} {}\n", uv.x(), uv.y());
    for (std::size_t t = 0; t < part.mesh->triangles.size(); ++t) add_face(text, *part.mesh, t, offsets);
    offsets.point += static_cast<int>(part.positions.size());
    offsets.uv += static_cast<int>(part.mesh->uvs.size());
  }
  return text;
}

template <typename Number>
static void add_bytes(std::string& text, const Number* numbers, std::size_t count) {
  text.append(reinterpret_cast<const char*>(numbers), count * sizeof(Number));
}

static std::string ply_header(const std::vector<GeometryPart>& parts) {
  std::size_t points = 0;
  std::size_t triangles = 0;
  for (const GeometryPart& part : parts) {
    points += part.positions.size();
    triangles += part.mesh->triangles.size();
  }
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      points, triangles);
}

std::string to_ply(const std::vector<GeometryPart>& parts) {
  std::string text = ply_header(parts);
  for (const GeometryPart& part : parts) {
    for (const Vec3f& position : part.positions) add_bytes(text, position.data(), 3);
  }
  int offset = 0;
  for (const GeometryPart& part : parts) {
    for (const Triangle& triangle : part.mesh->triangles) {
      const Triangle shifted = {triangle[0] + offset, triangle[1] + offset, triangle[2] + offset};
      text += '\3';
      add_bytes(text, shifted.data(), 3);
    }
    offset += static_cast<int>(part.positions.size());
  }
  return text;
}

}  // namespace drape::app
