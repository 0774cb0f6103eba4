#include "scene/override.h"

#include <fmt/format.h>

#include "scene/quantity.h"
#include "scene/yaml_document.h"

namespace drape {
namespace {

constexpr std::size_t most_steps = 16;  // no key of a scene is deeper

std::vector<std::string> split_path(std::string_view path) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    names.emplace_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

// The whole value stands on the command line, which has no lines. The parts are numbered.
void set_place(Node& node, Place& place) {
  ++place.column;
  node.place = place;
  node.is_overridden = true;
  for (Node& item : node.items) set_place(item, place);
  for (MapEntry& entry : node.entries) {
    ++place.column;
    entry.place = place;
    set_place(entry.value, place);
  }
}

Node* step_into_list(Node& list, const std::string& name, const Place& place, ProblemList& problems) {
  const ParsedNumber index = parse_quantity(name, Quantity::plain);
  for (std::size_t i = 0; i < list.items.size(); ++i)
    if (index.mistake.empty() && index.value == static_cast<double>(i)) return &list.items[i];
  problems.add(place, fmt::format("`{}` must be the number of an item, from 0, in a list of {}", name,
                                  list.items.size()));
  return nullptr;
}

Node* step_into(Node& node, const std::string& name, const Place& place, ProblemList& problems) {
  if (node.kind == Node::Kind::sequence) return step_into_list(node, name, place, problems);
  if (node.kind != Node::Kind::map) node = Node{Node::Kind::map, place, {}, {}, {}};
  if (MapEntry* entry = find_entry(node, name)) {
    entry->place = place;
    return &entry->value;
  }
  node.entries.push_back({name, place, {Node::Kind::null, place, {}, {}, {}}});
  return &node.entries.back().value;
}

// Mistakes of the value's own syntax count lines in a text that nobody sees.
std::optional<Node> parse_value(std::string_view text, const Place& place, ProblemList& problems) {
  ProblemList found;
  DocumentBudget budget;
  auto value = parse_yaml(text, place.file, budget, found);
  if (!found.empty()) {
    problems.add(place, "the value is not YAML");
    return std::nullopt;
  }
  Place part = place;
  set_place(*value, part);
  return value;
}

}  // namespace

void apply_override(const std::string& text, Node& root, ProblemList& problems) {
  const Place place{std::make_shared<const std::string>("-D " + text)};
  const std::size_t equals = text.find('=');
  const std::vector<std::string> names = split_path(std::string_view(text).substr(0, equals));
  if (equals == std::string::npos || names.front().empty() || names.size() > most_steps)
    return problems.add(place, "must be key.path=value, such as time.step=1 ms");
  if (names.front() == "include") return problems.add(place, "include can be given in files only");
  auto value = parse_value(std::string_view(text).substr(equals + 1), place, problems);
  if (!value) return;
  Node* target = &root;
  for (const std::string& name : names) {
    target = step_into(*target, name, place, problems);
    if (target == nullptr) return;
  }
  *target = std::move(*value);
}

}  // namespace drape
