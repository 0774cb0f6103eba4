#include "scene/section.h"

#include <fmt/format.h>

#include <stdexcept>

#include "scene/suggestion.h"

namespace drape {

static std::string title(const Section& section) { return section.path.empty() ? "the scene" : section.path; }

static void check_keys(const Section& section) {
  const std::vector<std::string_view> known = key_names(section.keys);
  for (const MapEntry& entry : section.node->entries)
    if (find_key(section.keys, entry.key) == nullptr)
      section.problems->add(entry.place, fmt::format("unknown key {} in {}{}", quote(entry.key),
                                                     title(section), suggestion(entry.key, known, "keys")));
  for (const std::string_view name : known)
    if (find_key(section.keys, name)->required && !has(section, name))
      section.problems->add(section.place, fmt::format("missing key `{}` in {}", name, title(section)));
}

static Section open_map(const Node& node, Section section) {
  if (node.kind == Node::Kind::map) {
    section.node = &node;
    check_keys(section);
  } else if (node.kind == Node::Kind::null) {
    section.problems->add_cause(node.place,
                                fmt::format("{} is empty: give it keys, or leave it out", title(section)));
  } else {
    section.problems->add_cause(node.place,
                                fmt::format("{} must be a map, not {}", title(section), describe(node)));
  }
  return section;
}

// The table's line for a key that the program reads: one that is missing there is a mistake of the program's.
static const Key& listed_key(const Section& section, std::string_view name) {
  const Key* key = find_key(section.keys, name);
  if (key == nullptr) throw std::logic_error(fmt::format("no key {} in the table", path_of(section, name)));
  return *key;
}

Section open_scene(const Node& root, ProblemList& problems) {
  return open_map(root, {nullptr, "", "", {root.place.file, 1, 1}, &problems});
}

Section open_section(const Section& parent, std::string_view name) {
  const Key& key = listed_key(parent, name);
  Section section{nullptr, keys_listed_under(key), path_of(parent, name), parent.place, parent.problems};
  const MapEntry* entry = parent.node ? find_entry(*parent.node, name) : nullptr;
  if (entry == nullptr) return section;
  section.place = entry->place;
  return open_map(entry->value, std::move(section));
}

static bool is_name(std::string_view text) {
  constexpr std::size_t longest = 64;
  return !text.empty() && text.size() <= longest &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
             std::string_view::npos;
}

// The value of a key, or null and a problem where it is of another kind than the table says.
static const Node* find_of_kind(const Section& parent, std::string_view name, Node::Kind kind) {
  const Node* node = find_value(parent, name);
  if (node == nullptr || node->kind == kind) return node;
  parent.problems->add(node->place,
                       fmt::format("{} must be a {}, not {}", path_of(parent, name),
                                   kind == Node::Kind::map ? "map from names" : "list", describe(*node)));
  return nullptr;
}

static Section open_child(const Section& parent, std::string_view name, const std::string& child_path,
                          const Place& place, const Node& node) {
  return open_map(node,
                  {nullptr, keys_listed_under(listed_key(parent, name)), child_path, place, parent.problems});
}

std::vector<NamedSection> open_named(const Section& parent, std::string_view name, int most) {
  const Node* node = find_of_kind(parent, name, Node::Kind::map);
  if (node == nullptr) return {};
  const std::string path = path_of(parent, name);
  if (node->entries.size() > static_cast<std::size_t>(most)) {
    parent.problems->add(node->place, fmt::format("{} must be at most {}", path, most));
    return {};
  }
  std::vector<NamedSection> sections;
  for (const MapEntry& entry : node->entries) {
    if (!is_name(entry.key)) {
      parent.problems->add(entry.place,
                           fmt::format("the name {} in {} must be of letters, digits, _ and -, at "
                                       "most 64",
                                       quote(entry.key), path));
      continue;
    }
    Section section = open_child(parent, name, path + "." + entry.key, entry.place, entry.value);
    if (section.node != nullptr) sections.push_back({entry.key, std::move(section)});
  }
  return sections;
}

std::vector<Section> open_list(const Section& parent, std::string_view name) {
  const Node* node = find_of_kind(parent, name, Node::Kind::sequence);
  if (node == nullptr) return {};
  std::vector<Section> sections;
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const Node& item = node->items[i];
    Section section =
        open_child(parent, name, fmt::format("{}[{}]", path_of(parent, name), i), item.place, item);
    if (section.node != nullptr) sections.push_back(std::move(section));
  }
  return sections;
}

bool has(const Section& section, std::string_view name) { return find_value(section, name) != nullptr; }

const Node* find_value(const Section& section, std::string_view name) {
  const MapEntry* entry = section.node ? find_entry(*section.node, name) : nullptr;
  return entry ? &entry->value : nullptr;
}

std::string path_of(const Section& section, std::string_view name) {
  return section.path.empty() ? std::string(name) : section.path + "." + std::string(name);
}

std::string_view exactly_one(const Section& section, std::string_view what,
                             std::initializer_list<std::string_view> names) {
  std::string_view first;
  for (const std::string_view name : names) {
    const MapEntry* entry = find_entry(*section.node, name);
    if (entry == nullptr) continue;
    if (!first.empty()) {
      section.problems->add(
          entry->place, fmt::format("{} has two {}s, {} and {}: give one", section.path, what, first, name));
      return {};
    }
    first = name;
  }
  if (first.empty())
    section.problems->add(section.place, fmt::format("{} has no {}: give one of {}", section.path, what,
                                                     join(std::vector(names))));
  return first;
}

}  // namespace drape
