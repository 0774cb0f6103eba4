#include "scene/read_vertices.h"

#include <fmt/format.h>

#include "scene/section_values.h"

namespace drape {

std::vector<int> read_vertices(const Section& section, int count) {
  const Node& node = *find_value(section, "vertices");
  const std::string path = path_of(section, "vertices");
  if (node.kind != Node::Kind::sequence || node.items.empty()) {
    section.problems->add(
        node.place, fmt::format("{} must be a list of numbers of vertices, such as [0, 9], not {}", path,
                                describe(node)));
    return {};
  }
  const NumberRule rule{Quantity::plain, 0, static_cast<double>(count) - 1, true};
  std::vector<int> vertices;
  for (std::size_t i = 0; i < node.items.size(); ++i)
    if (const auto vertex = number_in(node.items[i], rule, fmt::format("{}[{}]", path, i), *section.problems))
      vertices.push_back(static_cast<int>(*vertex));
  return vertices;
}

}  // namespace drape
