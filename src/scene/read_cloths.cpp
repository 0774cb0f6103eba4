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
#include "simulation/pressure.h"

namespace drape {
namespace {

// Opening a section reports what is missing in it, so what is read here is whole or already a problem.
std::optional<TriangleMesh> read_grid(const Section& cloth, int& points_left) {
  const std::size_t problems_before = cloth.problems->size();
  const Section grid = open_section(cloth, "grid");
  std::array<double, 2> size{1, 1};
  std::array<int, 2> points{2, 2};
  read_numbers(grid, "size", size);
  read_numbers(grid, "points", points);
  if (cloth.problems->size() > problems_before) return std::nullopt;
  if (points[0] * points[1] > points_left) {
    cloth.problems->add(find_value(grid, "points")->place,
                        fmt::format("{}: the grids of a scene have at most {} points together",
                                    path_of(grid, "points"), most_grid_points));
    return std::nullopt;
  }
  points_left -= points[0] * points[1];
  return make_grid(size, points);
}

std::optional<TriangleMesh> read_shape(const Section& cloth, const std::filesystem::path& scene_folder,
                                       int& points_left) {
  const std::string_view shape = exactly_one(cloth, "shape", {"grid", "mesh"});
  if (shape == "grid") return read_grid(cloth, points_left);
  if (shape == "mesh") return read_mesh_key(cloth, scene_folder);
  return std::nullopt;
}

void read_material(const Section& cloth, ClothMaterial& material) {
  const Section section = open_section(cloth, "material");
  read_number(section, "density", material.density);
  read_number(section, "thickness", material.thickness);
  read_number(section, "stretch", material.stretch_stiffness);
  read_number(section, "bend", material.bend_stiffness);
  read_number(section, "damping", material.damping);
  read_number(section, "friction", material.friction);
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
  int points_left = most_grid_points;
  const Node* node = find_value(scene, "cloths");
  if (node != nullptr && node->kind == Node::Kind::map && node->entries.empty())
    scene.problems->add(node->place, "cloths is empty: a scene needs at least one");
  for (const auto& [name, section] : open_named(scene, "cloths", most_cloths)) {
    ClothDescription cloth;
    cloth.input.name = name;
    RigidMotion place;
    read_place(section, place);
    read_material(section, cloth.input.material);
    read_look(section, cloth.look);
    auto mesh = read_shape(section, scene_folder, points_left);
    if (!mesh) continue;
    cloth.input.start_positions = placed(mesh->positions, place);
    cloth.input.mesh = std::move(*mesh);
    read_pressure(section, cloth.input);
    cloth.input.pins = read_pins(section, cloth.input, colliders, fps);
    cloths.push_back(std::move(cloth));
  }
  return cloths;
}

}  // namespace drape
