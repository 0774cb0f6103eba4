#include "scene/read_cloths.h"

#include <fmt/format.h>

#include <algorithm>

#include "mesh/primitives.h"
#include "mesh/topology.h"
#include "scene/read_look.h"
#include "scene/read_mesh_key.h"
#include "scene/read_motion.h"
#include "scene/read_pins.h"
#include "scene/section_values.h"
#include "scene/suggestion.h"
#include "simulation/pressure.h"

namespace drape {
namespace {

// False, and a problem, where `count` more points are more than a scene may have.
bool take_points(double count, const Section& shape, std::string_view key, double& points_left) {
  if (count > points_left) {
    shape.problems->add(find_value(shape, key)->place,
                        fmt::format("{}: the grids and discs of a scene have at most {} points together",
                                    path_of(shape, key), most_made_points));
    return false;
  }
  points_left -= count;
  return true;
}

// Opening a section reports what is missing in it, so what is read here is whole or already a problem.
std::optional<TriangleMesh> read_grid(const Section& cloth, double& points_left) {
  const std::size_t problems_before = cloth.problems->size();
  const Section grid = open_section(cloth, "grid");
  std::array<double, 2> size{1, 1};
  std::array<int, 2> points{2, 2};
  read_numbers(grid, "size", size);
  read_numbers(grid, "points", points);
  if (cloth.problems->size() > problems_before) return std::nullopt;
  if (!take_points(points[0] * points[1], grid, "points", points_left)) return std::nullopt;
  return make_grid(size, points);
}

std::optional<TriangleMesh> read_disc(const Section& cloth, double& points_left) {
  const std::size_t problems_before = cloth.problems->size();
  const Section disc = open_section(cloth, "disc");
  double diameter = 1, edge = 0.1;
  read_number(disc, "diameter", diameter);
  read_number(disc, "edge", edge);
  if (cloth.problems->size() > problems_before) return std::nullopt;
  if (edge > diameter / 4) {
    cloth.problems->add(find_value(disc, "edge")->place,
                        fmt::format("{} must be at most a quarter of the diameter, {} m, but is {} m",
                                    path_of(disc, "edge"), diameter / 4, edge));
    return std::nullopt;
  }
  if (!take_points(count_disc_points(diameter, edge), disc, "edge", points_left)) return std::nullopt;
  return make_disc(diameter, edge);
}

std::optional<ShapedMesh> start_as_at_rest(std::optional<TriangleMesh> mesh) {
  if (!mesh) return std::nullopt;
  ShapedMesh shaped{std::move(*mesh), {}};
  shaped.start_positions = shaped.mesh.positions;
  return shaped;
}

std::optional<ShapedMesh> read_shape(const Section& cloth, const std::filesystem::path& scene_folder,
                                     double& points_left) {
  const std::string_view shape = exactly_one(cloth, "shape", {"grid", "disc", "mesh"});
  if (shape == "mesh" && has(cloth, "rest")) return read_mesh_and_rest(cloth, scene_folder);
  if (has(cloth, "rest"))
    cloth.problems->add(find_value(cloth, "rest")->place,
                        path_of(cloth, "rest") + " is for a `mesh`: a grid or a disc is at rest as it is");
  if (shape == "mesh") return start_as_at_rest(read_mesh_key(cloth, scene_folder));
  if (shape == "grid") return start_as_at_rest(read_grid(cloth, points_left));
  if (shape == "disc") return start_as_at_rest(read_disc(cloth, points_left));
  return std::nullopt;
}

void read_warp(const Section& section, Vec3& warp) {
  read_numbers(section, "warp", warp);
  if (warp.isZero(0))
    section.problems->add(
        find_value(section, "warp")->place,
        fmt::format("{} is a direction, and must not be [0, 0, 0]", path_of(section, "warp")));
}

void read_material_keys(const Section& section, ClothMaterial& material) {
  read_number(section, "density", material.elastic.density);
  read_number(section, "thickness", material.thickness);
  read_pair(section, "stretch", material.elastic.stretch_stiffness);
  read_number(section, "shear", material.elastic.shear_stiffness);
  read_number(section, "poisson", material.elastic.poisson_ratio);
  read_pair(section, "bend", material.elastic.bend_stiffness);
  read_warp(section, material.warp);
  read_number(section, "damping", material.elastic.damping);
  read_number(section, "strain_limit", material.elastic.strain_limit);
  read_number(section, "friction", material.friction);
}

struct NamedMaterial {
  std::string name;
  ClothMaterial material;
};

std::vector<NamedMaterial> read_materials(const Section& scene) {
  std::vector<NamedMaterial> materials;
  for (const auto& [name, section] : open_named(scene, "materials", most_materials)) {
    materials.push_back({name, {}});
    read_material_keys(section, materials.back().material);
  }
  return materials;
}

void report_unknown_material(const Section& cloth, const Node& node,
                             const std::vector<NamedMaterial>& materials) {
  std::vector<std::string_view> names;
  for (const NamedMaterial& known : materials) names.push_back(known.name);
  cloth.problems->add(
      node.place,
      fmt::format("{}: no material {}{}", path_of(cloth, "material"), quote(node.text),
                  names.empty() ? ", since the scene has no `materials`: include a file that has them, as "
                                  "materials/silk.yaml does, or give a map"
                                : suggestion(node.text, names, "materials")));
}

// A map of its own, or the name of one of the scene's materials.
void read_material(const Section& cloth, const std::vector<NamedMaterial>& materials,
                   ClothMaterial& material) {
  const Node* node = find_value(cloth, "material");
  if (node == nullptr || node->kind != Node::Kind::scalar)
    return read_material_keys(open_section(cloth, "material"), material);
  const auto has_its_name = [&](const NamedMaterial& known) { return known.name == node->text; };
  const auto found = std::find_if(materials.begin(), materials.end(), has_its_name);
  if (found == materials.end()) return report_unknown_material(cloth, *node, materials);
  material = found->material;
}

// A pressure needs an inside, and a cloth that holds it.
void read_pressure(const Section& cloth, ClothInput& input) {
  const Node* node = find_value(cloth, "pressure");
  if (node == nullptr) return;
  read_number(cloth, "pressure", input.pressure);
  if (input.pressure == 0) return;
  const std::string path = path_of(cloth, "pressure");
  const TriangleMesh& mesh = input.mesh;
  const double most = doubling_pressure(input);
  if (!is_closed(build_topology(static_cast<int>(mesh.positions.size()), mesh.triangles)))
    cloth.problems->add(node->place,
                        path +
                            " needs a cloth that is closed, and this one has open edges: give it "
                            "a closed mesh, or leave the pressure out");
  else if (input.pressure > most)
    cloth.problems->add(
        node->place, fmt::format("{} of {} Pa is more than the cloth holds: over {:.5g} Pa it would grow to "
                                 "more than twice its size; lower it, or raise material.stretch",
                                 path, input.pressure, most));
}

// In the order of the text, which is that of the simulation's colliders.
std::vector<std::string_view> collider_names(const Section& scene) {
  std::vector<std::string_view> names;
  if (const Node* colliders = find_value(scene, "colliders"))
    for (const MapEntry& entry : colliders->entries) names.push_back(entry.key);
  return names;
}

std::vector<Vec3> placed(const std::vector<Vec3>& points, const RigidMotion& place) {
  const RigidPose pose = pose_at(place, 0);
  std::vector<Vec3> result(points.size());
  std::transform(points.begin(), points.end(), result.begin(), pose);
  return result;
}

}  // namespace

std::vector<ClothDescription> read_cloths(const Section& scene, const std::filesystem::path& scene_folder,
                                          double fps) {
  std::vector<ClothDescription> cloths;
  const std::vector<std::string_view> colliders = collider_names(scene);
  double points_left = most_made_points;
  const std::vector<NamedMaterial> materials = read_materials(scene);
  const Node* node = find_value(scene, "cloths");
  if (node != nullptr && node->kind == Node::Kind::map && node->entries.empty())
    scene.problems->add(node->place, "cloths is empty: a scene needs at least one");
  for (const auto& [name, section] : open_named(scene, "cloths", most_cloths)) {
    ClothDescription cloth;
    cloth.place = section.place;
    cloth.input.name = name;
    RigidMotion place;
    read_place(section, place);
    read_material(section, materials, cloth.input.material);
    read_look(section, cloth.look);
    auto shape = read_shape(section, scene_folder, points_left);
    if (!shape) continue;
    cloth.input.start_positions = placed(shape->start_positions, place);
    cloth.input.mesh = std::move(shape->mesh);
    read_numbers(section, "velocity", cloth.input.start_velocity);
    read_pressure(section, cloth.input);
    cloth.input.pins = read_pins(section, cloth.input, colliders, fps);
    cloths.push_back(std::move(cloth));
  }
  return cloths;
}

}  // namespace drape
