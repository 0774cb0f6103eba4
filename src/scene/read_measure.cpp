#include "scene/read_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "mesh/shadow.h"
#include "scene/section_values.h"
#include "scene/suggestion.h"

namespace drape {
namespace {

// A cloth or a collider that a section names, by its number. `group` is where the scene has them: one of it
// that is not among `parts` has mistakes of its own, which are enough.
template <typename Part>
std::optional<int> read_name_of(const Section& section, std::string_view key, const std::vector<Part>& parts,
                                const Section& scene, std::string_view group) {
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

bool check_support(const Section& section, const ColliderDescription& support) {
  if (std::holds_alternative<CylinderShape>(support.input.shape)) return true;
  section.problems->add(find_value(section, "support")->place,
                        fmt::format("{} must be a cylinder, and {} is none", path_of(section, "support"),
                                    quote(support.input.name)));
  return false;
}

void check_cloth(const Section& section, const ClothDescription& cloth, const ColliderDescription& support) {
  const double area = surface_area(cloth.input.mesh.positions, cloth.input.mesh.triangles);
  const double radius = std::get<CylinderShape>(support.input.shape).radius;
  const double support_area = std::numbers::pi * radius * radius;
  if (area > support_area) return;
  section.problems->add(
      find_value(section, "cloth")->place,
      fmt::format("{}: {} must be larger than what it lies on, but has {:.4g} m2, and {} {:.4g} m2",
                  path_of(section, "cloth"), quote(cloth.input.name), area, quote(support.input.name),
                  support_area));
}

}  // namespace

void read_measure(const Section& scene, SceneDescription& description) {
  const Section measure = open_section(scene, "measure");
  const Section drape = open_section(measure, "drape");
  if (drape.node == nullptr) return;
  const auto cloth = read_name_of(drape, "cloth", description.cloths, scene, "cloths");
  const auto support = read_name_of(drape, "support", description.colliders, scene, "colliders");
  if (!support || !check_support(drape, description.colliders[*support]) || !cloth) return;
  // A size that was refused has its default here, of which there is nothing to say.
  if (scene.problems->empty())
    check_cloth(drape, description.cloths[*cloth], description.colliders[*support]);
  description.drape_test = DrapeTest{*cloth, *support};
}

}  // namespace drape
