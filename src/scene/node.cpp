#include "scene/node.h"

#include <algorithm>
#include <utility>

namespace drape {

const MapEntry* find_entry(const Node& map, std::string_view key) {
  const auto found = std::find_if(map.entries.begin(), map.entries.end(),
                                  [&](const MapEntry& entry) { return entry.key == key; });
  return found == map.entries.end() ? nullptr : &*found;
}

MapEntry* find_entry(Node& map, std::string_view key) {
  return const_cast<MapEntry*>(find_entry(std::as_const(map), key));
}

std::size_t count_nodes(const Node& node) {
  std::size_t count = 1;
  for (const Node& item : node.items) count += count_nodes(item);
  for (const MapEntry& entry : node.entries) count += count_nodes(entry.value);
  return count;
}

std::size_t count_text(const Node& node) {
  std::size_t count = node.text.size();
  for (const Node& item : node.items) count += count_text(item);
  for (const MapEntry& entry : node.entries) count += entry.key.size() + count_text(entry.value);
  return count;
}

int depth_of(const Node& node) {
  int deepest = 0;
  for (const Node& item : node.items) deepest = std::max(deepest, depth_of(item));
  for (const MapEntry& entry : node.entries) deepest = std::max(deepest, depth_of(entry.value));
  return deepest + 1;
}

// Not within a character, and on one line.
static std::size_t quotable_length(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::size_t length = std::min({longest, text.size(), text.find('\n')});
  while (length > 0 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80)
    --length;
  return length;
}

std::string quote(std::string_view text) {
  const std::size_t length = quotable_length(text);
  return "`" + std::string(text.substr(0, length)) + (length < text.size() ? "...`" : "`");
}

std::string describe(const Node& node) {
  switch (node.kind) {
    case Node::Kind::map:
      return "a map";
    case Node::Kind::sequence:
      return node.items.empty() ? "an empty list" : "a list";
    case Node::Kind::null:
      return "empty";
    case Node::Kind::scalar:
      break;
  }
  return quote(node.text);
}

}  // namespace drape
