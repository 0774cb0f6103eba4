#include "scene/variables.h"

#include <fmt/format.h>

#include <map>

#include "scene/suggestion.h"

namespace drape {
namespace {

constexpr std::size_t longest_text = 1000;  // of a scalar that variables went into

class Substitution {
 public:
  explicit Substitution(ProblemList& problems) : problems_(problems) {}

  void define(std::string_view name, const Node& value) { values_.emplace(name, &value); }

  void apply(Node& node, int depth) {
    if (node.kind == Node::Kind::scalar) return replace(node, depth);
    for (Node& item : node.items) apply(item, depth + 1);
    for (MapEntry& entry : node.entries) apply(entry.value, depth + 1);
  }

 private:
  void replace(Node& node, int depth) {
    if (node.text.find("${") == std::string::npos) return;
    const bool is_one_name = node.text.starts_with("${") && node.text.find('}') == node.text.size() - 1;
    if (!is_one_name) return replace_within(node);
    const Node* value = look_up(node, std::string_view(node.text).substr(2, node.text.size() - 3));
    if (value == nullptr || !take_budget(*value, node.place, depth)) return;
    const Place place = node.place;
    const bool is_overridden = node.is_overridden || value->is_overridden;
    node = Node(*value);
    node.place = place;
    node.is_overridden = is_overridden;
  }

  void replace_within(Node& node) {
    std::string result;
    std::string_view rest = node.text;
    for (std::size_t begin = 0; (begin = rest.find("${")) != std::string_view::npos;) {
      const std::size_t end = rest.find('}', begin);
      if (end == std::string_view::npos)
        return problems_.add_cause(node.place, fmt::format("`${{` without `}}` in {}", describe(node)));
      const std::string_view name = rest.substr(begin + 2, end - begin - 2);
      const Node* value = look_up(node, name);
      if (value == nullptr) return;
      if (value->kind != Node::Kind::scalar)
        return problems_.add_cause(
            node.place, fmt::format("variable {} is {}, which cannot stand inside of a text", quote(name),
                                    describe(*value)));
      result.append(rest.substr(0, begin)).append(value->text);
      node.is_overridden |= value->is_overridden;
      rest.remove_prefix(end + 1);
      if (result.size() > longest_text)
        return problems_.add_cause(node.place,
                                   fmt::format("longer than {} letters with its variables", longest_text));
    }
    node.text = result.append(rest);
  }

  const Node* look_up(const Node& node, std::string_view name) {
    const auto found = values_.find(name);
    if (found != values_.end()) {
      problems_.follow(node.place, found->second->place);
      return found->second;
    }
    std::vector<std::string_view> names;
    for (const auto& [known, value] : values_) names.push_back(known);
    problems_.add_cause(node.place, fmt::format("no variable {} above this{}", quote(name),
                                                names.empty() ? "" : suggestion(name, names, "variables")));
    return nullptr;
  }

  // Variables that hold each other twice would double the tree with each line.
  bool take_budget(const Node& value, const Place& place, int depth) {
    const std::size_t nodes = count_nodes(value), text = count_text(value);
    if (nodes > nodes_left_ || text > text_left_ || depth + depth_of(value) > largest_node_depth) {
      problems_.add_cause(
          place, fmt::format("more than {} values, a megabyte, or {} levels, with variables in place",
                             largest_node_count, largest_node_depth));
      return false;
    }
    nodes_left_ -= nodes;
    text_left_ -= text;
    return true;
  }

  ProblemList& problems_;
  std::map<std::string_view, const Node*, std::less<>> values_;
  std::size_t nodes_left_ = largest_node_count;
  std::size_t text_left_ = std::size_t{1} << 20;
};

}  // namespace

void substitute_variables(Node& root, ProblemList& problems) {
  Substitution substitution(problems);
  Node variables;
  if (MapEntry* entry = find_entry(root, "vars")) {
    variables = std::move(entry->value);
    root.entries.erase(root.entries.begin() + (entry - root.entries.data()));
    if (variables.kind != Node::Kind::map)
      problems.add(variables.place,
                   fmt::format("vars must be a map from names, not {}", describe(variables)));
  }
  for (MapEntry& entry : variables.entries) {
    substitution.apply(entry.value, 2);
    substitution.define(entry.key, entry.value);
  }
  substitution.apply(root, 1);
}

}  // namespace drape
