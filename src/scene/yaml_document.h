#pragma once

// The only file pair that includes yaml-cpp.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "scene/node.h"
#include "scene/problem_list.h"

namespace drape {

inline constexpr std::size_t largest_document = std::size_t{1} << 20;  // bytes, before and after aliases

// What is left of the limits that all documents of one scene share.
struct DocumentBudget {
  std::size_t nodes = largest_node_count;
  std::size_t text = largest_document;
};

// Reads one YAML document of UTF-8 text. Aliases are expanded, and counted before they are; tags, and keys
// that are not text, are refused. A mistake that the parser cannot read past gives nothing and one problem; a
// key that is there twice is a problem, and its second value is dropped. An empty document is a null node.
std::optional<Node> parse_yaml(std::string_view text, const std::shared_ptr<const std::string>& file,
                               DocumentBudget& budget, ProblemList& problems);

}  // namespace drape
