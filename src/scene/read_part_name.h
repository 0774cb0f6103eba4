#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "scene/section_values.h"
#include "scene/suggestion.h"

namespace drape {

// A cloth or a collider that a section names, by its number. `group` is where the scene has them: one of it
// that is not among `parts` has mistakes of its own, which are enough.
template <typename Part>
std::optional<int> read_part_name(const Section& section, std::string_view key,
                                  const std::vector<Part>& parts, const Section& scene,
                                  std::string_view group) {
  std::string name;
  read_text(section, key, name);
  if (name.empty()) return std::nullopt;
  const auto has_its_name = [&](const Part& part) { return part.input.name == name; };
  const auto found = std::find_if(parts.begin(), parts.end(), has_its_name);
  if (found != parts.end()) return static_cast<int>(found - parts.begin());
  const Node* all = find_value(scene, group);
  if (all != nullptr && find_entry(*all, name) != nullptr) return std::nullopt;
  std::vector<std::string_view> names;
  for (const Part& part : parts) names.push_back(part.input.name);
  section.problems->add(find_value(section, key)->place,
                        fmt::format("{}: {} is not in {}{}", path_of(section, key), quote(name), group,
                                    names.empty() ? ", which has none" : suggestion(name, names, group)));
  return std::nullopt;
}

}  // namespace drape
