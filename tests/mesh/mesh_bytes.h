#pragma once

#include <string>

namespace drape::test {

// A square of two triangles with texture coordinates, as files hold it.
inline const std::string square_obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";

inline const std::string square_ply =
    "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nproperty float u\nproperty float v\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n4 0 1 2 3\n";

template <typename Number>
std::string as_bytes(Number number, bool big_endian) {
  std::string bytes(reinterpret_cast<const char*>(&number), sizeof number);
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

inline std::string square_binary_ply(bool big_endian) {
  std::string text =
      std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
      "_endian 1.0\nelement vertex 4\nproperty double x\nproperty float y\nproperty short z\n"
      "property uchar red\nelement face 1\nproperty uchar flags\n"
      "property list uchar uint vertex_indices\nproperty list uchar float texcoord\nend_header\n";
  const int corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const auto& [x, y] : corners)
    text += as_bytes(double(x), big_endian) + as_bytes(float(y), big_endian) +
            as_bytes(short{0}, big_endian) + '\x7f';
  text += std::string("\x01\x04", 2);
  for (unsigned i = 0; i < 4; ++i) text += as_bytes(i, big_endian);
  text += '\x08';
  for (const auto& [u, v] : corners) text += as_bytes(float(u), big_endian) + as_bytes(float(v), big_endian);
  return text;
}

}  // namespace drape::test
