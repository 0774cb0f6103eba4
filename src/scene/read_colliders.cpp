#include "scene/read_colliders.h"

#include <fmt/format.h>

#include "scene/read_look.h"
#include "scene/read_mesh_key.h"
#include "scene/read_motion.h"
#include "scene/read_sequence.h"
#include "scene/section_values.h"

namespace drape {
namespace {

// A plane's height is one of the ways to say where it is; two ways at once would hide a mistake.
ColliderShape read_plane(const Section& collider, RigidMotion& motion) {
  const Section plane = open_section(collider, "plane");
  const Node* place = find_value(collider, "place");
  if (has(plane, "y") && place != nullptr && find_entry(*place, "at") != nullptr)
    collider.problems->add(find_entry(*plane.node, "y")->place,
                           fmt::format("{} and {}.place.at both say where the plane is: give one",
                                       path_of(plane, "y"), collider.path));
  read_number(plane, "y", motion.at.y());
  return PlaneShape{};
}

ColliderShape read_sphere(const Section& collider) {
  SphereShape sphere{1};
  read_number(open_section(collider, "sphere"), "radius", sphere.radius);
  return sphere;
}

ColliderShape read_box(const Section& collider) {
  BoxShape box{Vec3::Ones()};
  read_numbers(open_section(collider, "box"), "size", box.size);
  return box;
}

ColliderShape read_cylinder(const Section& collider) {
  const Section section = open_section(collider, "cylinder");
  CylinderShape cylinder{1, 1};
  read_number(section, "radius", cylinder.radius);
  read_number(section, "height", cylinder.height);
  return cylinder;
}

ColliderShape read_capsule(const Section& collider) {
  const Section section = open_section(collider, "capsule");
  CapsuleShape capsule{1, 1};
  read_number(section, "radius", capsule.radius);
  read_number(section, "length", capsule.length);
  return capsule;
}

std::optional<MeshShape> read_mesh_shape(const Section& collider, const std::filesystem::path& scene_folder,
                                         double fps) {
  const std::string mesh = text_of(collider, "mesh"), clip = text_of(collider, "clip");
  const bool has_clip = has(collider, "clip");
  if (mesh.empty() || (has_clip && clip.empty())) return std::nullopt;
  if (names_sequence(mesh) && has_clip)
    collider.problems->add(
        find_entry(*collider.node, "clip")->place,
        fmt::format("{} is for one file that holds an animation, not for a sequence of files",
                    path_of(collider, "clip")));
  if (names_sequence(mesh)) return read_sequence(collider, scene_folder, fps);
  if (has_clip) return read_clip_key(collider, scene_folder, fps);
  auto still = read_mesh_key(collider, scene_folder);
  return still ? std::optional(MeshShape{std::move(*still)}) : std::nullopt;
}

std::optional<MeshShape> read_scaled_mesh(const Section& collider, const std::filesystem::path& scene_folder,
                                          double fps) {
  double scale = 1;
  read_number(collider, "scale", scale);
  auto shape = read_mesh_shape(collider, scene_folder, fps);
  if (!shape) return std::nullopt;
  for (Vec3& point : shape->mesh.positions) point *= scale;
  for (std::vector<Vec3>& points : shape->shapes)
    for (Vec3& point : points) point *= scale;
  return shape;
}

std::optional<ColliderShape> read_shape(const Section& collider, const std::filesystem::path& scene_folder,
                                        double fps, RigidMotion& motion) {
  const std::string_view shape =
      exactly_one(collider, "shape", {"plane", "sphere", "box", "cylinder", "capsule", "mesh"});
  if (shape == "plane") return read_plane(collider, motion);
  if (shape == "sphere") return read_sphere(collider);
  if (shape == "box") return read_box(collider);
  if (shape == "cylinder") return read_cylinder(collider);
  if (shape == "capsule") return read_capsule(collider);
  if (shape == "mesh") return read_scaled_mesh(collider, scene_folder, fps);
  return std::nullopt;
}

// Keys that say something of a mesh alone.
void check_mesh_keys(const Section& collider) {
  if (has(collider, "mesh")) return;
  for (const char* key : {"clip", "scale"})
    if (const MapEntry* entry = find_entry(*collider.node, key))
      collider.problems->add(entry->place, fmt::format("{} is for a mesh", path_of(collider, key)));
}

}  // namespace

std::vector<ColliderDescription> read_colliders(const Section& scene,
                                                const std::filesystem::path& scene_folder, double fps) {
  std::vector<ColliderDescription> colliders;
  for (const auto& [name, section] : open_named(scene, "colliders", most_colliders)) {
    ColliderDescription collider;
    collider.input.name = name;
    read_place(section, collider.input.motion);
    read_animation(section, fps, collider.input.motion);
    read_number(section, "friction", collider.input.friction);
    read_boolean(section, "visible", collider.visible);
    read_look(section, collider.look);
    check_mesh_keys(section);
    auto shape = read_shape(section, scene_folder, fps, collider.input.motion);
    if (!shape) continue;
    collider.input.shape = std::move(*shape);
    colliders.push_back(std::move(collider));
  }
  return colliders;
}

}  // namespace drape
