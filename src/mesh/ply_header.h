#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh_text.h"

namespace drape {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t byte_size(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;  // of a list: the type of the number of its values
};

struct PlyElement {
  std::string name;
  long long count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
};

// Reads up to the line end_header and leaves `words` at the first byte after it. `path` is for messages.
// Source: Greg Turk, "The PLY Polygon File Format", 1994.
PlyHeader read_ply_header(WordReader& words, const std::filesystem::path& path);

}  // namespace drape
