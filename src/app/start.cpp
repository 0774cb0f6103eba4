#include "app/start.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "app/fault_picture.h"
#include "app/triangle_names.h"
#include "contact/contact_step.h"
#include "mesh/loop_subdivision.h"
#include "render/png_file.h"
#include "scene/load.h"
#include "simulation/colliders.h"

namespace drape::app {
namespace fs = std::filesystem;

static constexpr double layer_gap = 20e-6;  // m, between layers that touch at first

namespace {

// Directions in which, and orders of the cloths by which, touching layers are tried apart: lying on each
// other in the order of the scene or the other, worn over each other, a cloth folded onto itself, on a
// collider.
enum class Direction { up, outward, inward, down };
enum class Order { rising, falling };

struct Colliders {
  std::vector<CertifiedCollider> solids;
  std::vector<RigidPose> poses;
};

}  // namespace

static Colliders colliders_at_start(const SceneDescription& scene) {
  Colliders colliders;
  for (const ColliderDescription& collider : scene.colliders) {
    colliders.solids.push_back(certified_collider(collider.input.shape));
    colliders.poses.push_back(collider_pose(collider.input, 0));
    if (deforms(collider.input))
      colliders.solids.back().surface->positions = collider_points(collider.input, 0);
  }
  return colliders;
}

static ClothSurface placed_surface(const SceneDescription& scene) {
  ClothSurface surface;
  for (const ClothDescription& cloth : scene.cloths) {
    const int first = static_cast<int>(surface.positions.size());
    for (const auto& [a, b, c] : cloth.input.mesh.triangles)
      surface.triangles.push_back({a + first, b + first, c + first});
    const std::vector<Vec3>& start = cloth.input.start_positions;
    surface.positions.insert(surface.positions.end(), start.begin(), start.end());
  }
  return surface;
}

static std::vector<Vec3> directions(const ClothSurface& surface, Direction direction) {
  if (direction == Direction::up) return std::vector<Vec3>(surface.positions.size(), Vec3(0, 1, 0));
  if (direction == Direction::down) return std::vector<Vec3>(surface.positions.size(), Vec3(0, -1, 0));
  std::vector<Vec3f> positions;
  for (const Vec3& p : surface.positions) positions.push_back(p.cast<float>());
  std::vector<Vec3> result;
  for (const Vec3f& normal : vertex_normals(positions, surface.triangles))
    result.push_back((direction == Direction::outward ? 1.0 : -1.0) * normal.cast<double>());
  return result;
}

static ClothSurface set_apart(const SceneDescription& scene, ClothSurface surface, Direction direction,
                              Order order) {
  const std::vector<Vec3> ways = directions(surface, direction);
  const int count = static_cast<int>(scene.cloths.size());
  std::size_t v = 0;
  for (int k = 0; k < count; ++k) {
    const int layer = order == Order::rising ? k + 1 : count - k;
    const std::size_t end = v + scene.cloths[k].input.start_positions.size();
    for (; v < end; ++v) surface.positions[v] += layer * layer_gap * ways[v];
  }
  return surface;
}

static CertifiedSurface judge(const SceneDescription& scene, const ClothSurface& surface,
                              const Colliders& colliders) {
  CertifiedSurface certified = certify(surface, colliders.solids, colliders.poses);
  if (!scene.self_collision) forget_pairs_within(triangle_ends(scene), certified);
  return certified;
}

static bool is_apart(const SceneDescription& scene, const CertifiedSurface& certified) {
  return is_clean(certified) &&
         (!scene.self_collision || certified.figures.smallest_gap >= ContactSettings().least_gap);
}

static std::size_t count_faults(const CertifiedSurface& certified) {
  return certified.intersecting.size() + certified.in_colliders.size();
}

Start find_start(const SceneDescription& scene) {
  const Colliders colliders = colliders_at_start(scene);
  const ClothSurface placed = placed_surface(scene);
  Start best{placed, judge(scene, placed, colliders)};
  if (is_apart(scene, best.certified)) return best;
  for (const Direction direction : {Direction::up, Direction::outward, Direction::inward, Direction::down})
    for (const Order order : {Order::rising, Order::falling}) {
      Start moved{set_apart(scene, placed, direction, order), {}};
      moved.certified = judge(scene, moved.surface, colliders);
      if (is_apart(scene, moved.certified)) return moved;
      if (count_faults(moved.certified) < count_faults(best.certified)) best = std::move(moved);
    }
  return best;
}

static Problem problem_at(const ClothDescription& cloth, std::string message) {
  return {cloth.place.file ? *cloth.place.file : "", cloth.place.line, cloth.place.column,
          std::move(message)};
}

static std::string others(std::size_t count, const std::string& what) {
  return count > 1 ? fmt::format(", and {} more {}", count - 1, what) : "";
}

static void add_meetings(const SceneDescription& scene, const Start& start, std::vector<Problem>& problems) {
  std::map<std::array<int, 2>, std::vector<TrianglePair>> by_cloths;
  for (const TrianglePair& pair : start.certified.intersecting)
    by_cloths[{cloth_of(scene, pair.first), cloth_of(scene, pair.second)}].push_back(pair);
  for (const auto& [cloths, pairs] : by_cloths) {
    const auto& [s, t] = pairs.front();
    const ClothDescription &first = scene.cloths[cloths[0]], &second = scene.cloths[cloths[1]];
    const std::string name = "cloths." + second.input.name;
    const std::string what =
        cloths[0] == cloths[1]
            ? fmt::format(
                  "{} starts through itself: {} meets {}{}; mend the mesh, or start from a flat shape", name,
                  name_in_cloth(scene, s), name_in_cloth(scene, t), others(pairs.size(), "pairs"))
            : fmt::format("{} starts through cloths.{}: {} meets {}{}; move one of them with `place`", name,
                          first.input.name, name_in_cloth(scene, t), name_in_cloth(scene, s),
                          others(pairs.size(), "pairs"));
    problems.push_back(problem_at(second, what));
  }
}

static void add_insides(const SceneDescription& scene, const Start& start, std::vector<Problem>& problems) {
  const Colliders colliders = colliders_at_start(scene);
  for (std::size_t c = 0; c < colliders.solids.size(); ++c) {
    std::map<int, std::vector<int>> by_cloth;
    for (const int t : triangles_in(start.surface, colliders.solids[c], colliders.poses[c]))
      by_cloth[cloth_of(scene, t)].push_back(t);
    for (const auto& [cloth, triangles] : by_cloth)
      problems.push_back(problem_at(
          scene.cloths[cloth],
          fmt::format("cloths.{} starts in colliders.{}: {}{}; move one of them with `place`",
                      scene.cloths[cloth].input.name, scene.colliders[c].input.name,
                      name_in_cloth(scene, triangles.front()), others(triangles.size(), "triangles"))));
  }
}

std::vector<Problem> start_problems(const SceneDescription& scene, const Start& start) {
  std::vector<Problem> problems;
  add_meetings(scene, start, problems);
  add_insides(scene, start, problems);
  return problems;
}

static void show_faults(const Start& start, const fs::path& picture, std::vector<Problem>& problems) {
  render::write_png(picture, draw_faults(start.surface, faulty_triangles(start.surface, start.certified)));
  for (Problem& problem : problems) problem.message += " (red in " + picture.string() + ")";
}

SimulationInput start_input(const SceneDescription& scene, const fs::path& folder) {
  const Start start = find_start(scene);
  std::vector<Problem> problems = start_problems(scene, start);
  if (!problems.empty()) {
    show_faults(start, folder / "start.png", problems);
    throw InputError(std::move(problems));
  }
  SimulationInput input = simulation_input(scene);
  auto next = start.surface.positions.begin();
  for (ClothInput& cloth : input.cloths) {
    const auto end = next + static_cast<std::ptrdiff_t>(cloth.start_positions.size());
    cloth.start_positions.assign(next, end);
    next = end;
  }
  return input;
}

}  // namespace drape::app
