#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

// Where something stands in a text; lines and columns (of bytes) count from 1. Line 0: in no text, but in
// what `file` names as a whole (a value of the command line); there the column is a number that tells its
// parts from each other.
struct Place {
  std::shared_ptr<const std::string> file;
  int line = 0;
  int column = 0;
};

struct MapEntry;

// A piece of YAML as a plain value. Scalars are kept as text: what reads a scalar knows what it has to be.
struct Node {
  enum class Kind { null, scalar, sequence, map };
  Kind kind = Kind::null;
  Place place;
  std::string text;               // of a scalar
  std::vector<Node> items;        // of a sequence
  std::vector<MapEntry> entries;  // of a map, in the order of the text, no key twice
  bool is_overridden = false;     // the command line says so, or a variable in it
};

struct MapEntry {
  std::string key;
  Place place;
  Node value;
};

inline constexpr int largest_node_depth = 64;
inline constexpr std::size_t largest_node_count = 100'000;

// The value of a key, or null where the map does not have it (or is no map).
const MapEntry* find_entry(const Node& map, std::string_view key);
MapEntry* find_entry(Node& map, std::string_view key);

// The number of nodes, the bytes of their scalars, and the depth (1 for a scalar) of a tree.
std::size_t count_nodes(const Node& node);
std::size_t count_text(const Node& node);
int depth_of(const Node& node);

// For messages: a text in backticks, cut where it is long; and "a map", "a list", "an empty list", "empty" or
// the text so.
std::string quote(std::string_view text);
std::string describe(const Node& node);

}  // namespace drape
