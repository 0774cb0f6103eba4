#include "scene/read_measure.h"

#include <fmt/format.h>

#include <numbers>

#include "mesh/shadow.h"
#include "scene/read_part_name.h"

namespace drape {
namespace {

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
  const auto cloth = read_part_name(drape, "cloth", description.cloths, scene, "cloths");
  const auto support = read_part_name(drape, "support", description.colliders, scene, "colliders");
  if (!support || !check_support(drape, description.colliders[*support]) || !cloth) return;
  // A size that was refused has its default here, of which there is nothing to say.
  if (scene.problems->empty())
    check_cloth(drape, description.cloths[*cloth], description.colliders[*support]);
  description.drape_test = DrapeTest{*cloth, *support};
}

}  // namespace drape
