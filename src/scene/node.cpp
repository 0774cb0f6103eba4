#include "scene/node.h"

#include <algorithm>

namespace drape {

const MapEntry* find_entry(const Node& map, std::string_view key) {
  const auto found = std::find_if(map.entries.begin(), map.entries.end(),
                                  [&](const MapEntry& entry) { return entry.key == key; });
  return found == map.entries.end() ? nullptr : &*found;
}

MapEntry* find_entry(Node& map, std::string_view key) {
  return const_cast<MapEntry*>(find_entry(static_cast<const Node&>(map), key));
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

std::string describe(const Node& node) {
  constexpr std::size_t longest_quote = 60;
  switch (node.kind) {
    case Node::Kind::map:
      return "a map";
    case Node::Kind::sequence:
      return "a list";
    case Node::Kind::null:
      return "empty";
    case Node::Kind::scalar:
      break;
  }
  if (node.text.size() <= longest_quote) return "`" + node.text + "`";
  return "`" + node.text.substr(0, longest_quote) + "...`";
}

}  // namespace drape
