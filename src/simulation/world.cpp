#include "simulation/world.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/topology.h"
#include "simulation/colliders.h"
#include "simulation/pressure.h"
#include "simulation/rest.h"
#include "simulation/sewing.h"
#include "simulation/strain_limits.h"

namespace drape {
namespace {

Sheet build_sheet(const SimulationInput& input) {
  Sheet sheet;
  for (const ClothInput& cloth : input.cloths) {
    const int first = static_cast<int>(sheet.rest_positions.size());
    const ClothMaterial& material = cloth.material;
    const std::vector<Vec3>& rest = cloth.mesh.positions;
    sheet.rest_positions.insert(sheet.rest_positions.end(), rest.begin(), rest.end());
    for (const auto& [a, b, c] : cloth.mesh.triangles)
      sheet.triangles.push_back({a + first, b + first, c + first});
    sheet.triangle_materials.resize(sheet.triangles.size(), static_cast<int>(sheet.materials.size()));
    sheet.materials.push_back(material.elastic);
    sheet.warp_directions.push_back(material.warp);
  }
  sheet.topology = build_topology(static_cast<int>(sheet.rest_positions.size()), sheet.triangles);
  return sheet;
}

void add_cloth_body(const Sheet& sheet, const ClothInput& cloth, ContactGeometry& geometry) {
  ContactBody body;
  body.thickness = cloth.material.thickness;
  body.friction = cloth.material.friction;
  body.vertex_begin = static_cast<int>(geometry.vertex_body.size());
  body.vertex_end = body.vertex_begin + static_cast<int>(cloth.mesh.positions.size());
  body.edge_begin = static_cast<int>(geometry.edges.size());
  body.triangle_begin = static_cast<int>(geometry.triangles.size());
  for (const Edge& edge : sheet.topology.edges)
    if (edge.vertices[0] >= body.vertex_begin && edge.vertices[0] < body.vertex_end)
      geometry.edges.push_back(edge.vertices);
  for (const Triangle& triangle : sheet.triangles)
    if (triangle[0] >= body.vertex_begin && triangle[0] < body.vertex_end)
      geometry.triangles.push_back(triangle);
  body.edge_end = static_cast<int>(geometry.edges.size());
  body.triangle_end = static_cast<int>(geometry.triangles.size());
  geometry.vertex_body.resize(body.vertex_end, static_cast<int>(geometry.bodies.size()));
  geometry.bodies.push_back(body);
}

void add_collider_body(const ColliderInput& collider, const ColliderPrimitives& primitives,
                       ContactGeometry& geometry) {
  ContactBody body;
  body.is_cloth = false;
  body.is_rigid = !deforms(collider);
  body.radius = primitives.radius;
  body.friction = collider.friction;
  body.vertex_begin = static_cast<int>(geometry.vertex_body.size());
  body.vertex_end = body.vertex_begin + static_cast<int>(primitives.points.size());
  body.edge_begin = static_cast<int>(geometry.edges.size());
  body.triangle_begin = static_cast<int>(geometry.triangles.size());
  const int first = body.vertex_begin;
  for (const auto& [a, b] : primitives.edges) geometry.edges.push_back({a + first, b + first});
  for (const auto& [a, b, c] : primitives.triangles)
    geometry.triangles.push_back({a + first, b + first, c + first});
  body.edge_end = static_cast<int>(geometry.edges.size());
  body.triangle_end = static_cast<int>(geometry.triangles.size());
  const int index = static_cast<int>(geometry.bodies.size());
  if (std::holds_alternative<PlaneShape>(collider.shape)) geometry.planes.push_back({index});
  geometry.vertex_body.resize(body.vertex_end, index);
  geometry.rest_positions.insert(geometry.rest_positions.end(), primitives.points.begin(),
                                 primitives.points.end());
  geometry.bodies.push_back(body);
}

void build_geometry(World& world) {
  ContactGeometry& geometry = world.geometry;
  geometry.self_collision = world.input.self_collision;
  for (const ClothInput& cloth : world.input.cloths) add_cloth_body(world.sheet, cloth, geometry);
  geometry.rest_positions = world.sheet.rest_positions;
  for (const ColliderInput& collider : world.input.colliders) {
    const ColliderPrimitives primitives = collider_primitives(collider.shape);
    add_collider_body(collider, primitives, geometry);
    world.collider_points.push_back(primitives.points);
  }
  world.contact_settings = contact_settings(geometry, world.step);
  world.contact_settings.fail_safe = world.input.fail_safe;
  if (world.input.model == DeformationModel::shape_matching)  // the others are there to be compared with
    world.contact_settings.edge_limits = build_strain_limits(world.sheet);
}

// The step of the paper's own experiments, if the scene wants none that is shorter.
double longest_air_interval(const SimulationInput& input) { return std::min(input.largest_step, 0.002); }

// The connected pieces that no pin holds.
std::vector<FreePiece> free_pieces(const World& world) {
  const int count = static_cast<int>(world.masses.size());
  const std::vector<int> piece_of = connected_pieces(count, world.sheet.triangles);
  std::vector<FreePiece> pieces;
  std::vector<char> held;
  for (int v = 0; v < count; ++v) {
    const std::size_t piece = static_cast<std::size_t>(piece_of[v]);
    if (piece >= pieces.size()) {
      pieces.resize(piece + 1);
      held.resize(piece + 1, 0);
    }
    pieces[piece].vertices.push_back(v);
    if (world.pinned[v]) held[piece] = 1;
  }
  std::vector<FreePiece> free;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    if (!held[p]) free.push_back(std::move(pieces[p]));
  return free;
}

void build_pinned_parts(World& world, std::vector<char> pinned) {
  world.pinned = std::move(pinned);
  world.model = build_model(world.input, world.sheet, world.masses, world.pinned, world.step);
  world.geometry.inverse_masses.assign(world.geometry.vertex_body.size(), 0.0);
  for (std::size_t v = 0; v < world.masses.size(); ++v)
    if (!world.pinned[v]) world.geometry.inverse_masses[v] = 1 / world.masses[v];
  world.free_pieces = free_pieces(world);
}

}  // namespace

StepChoice choose_steps(const SimulationInput& input) {
  const Sheet sheet = build_sheet(input);
  return choose_steps(input, sheet, lumped_masses(sheet));
}

World build_world(SimulationInput input) {
  World world;
  world.input = std::move(input);
  world.sheet = build_sheet(world.input);
  world.masses = lumped_masses(world.sheet);
  for (int t = 0; t < static_cast<int>(world.sheet.triangles.size()); ++t)
    world.triangle_masses.push_back(triangle_mass(world.sheet, t));
  world.steps_per_frame = choose_steps(world.input, world.sheet, world.masses).per_frame;
  world.step = world.input.frame_duration / world.steps_per_frame;
  world.steps_per_air = std::max(1, static_cast<int>(longest_air_interval(world.input) / world.step + 1e-9));
  world.still_way = largest_still_way(world.sheet);
  world.pressures = triangle_pressures(world.input.cloths);
  world.pins = build_pins(world.input.cloths);
  build_geometry(world);
  world.seams = sew(world.input, world.geometry);
  build_pinned_parts(world, pinned_vertices(world.pins, world.masses.size(), 0));
  return world;
}

State initial_state(const World& world) {
  State state;
  for (const ClothInput& cloth : world.input.cloths) {
    state.positions.insert(state.positions.end(), cloth.start_positions.begin(), cloth.start_positions.end());
    state.velocities.resize(state.positions.size(), cloth.start_velocity);
  }
  for (std::size_t c = 0; c < world.input.colliders.size(); ++c) {
    for (const Vec3& point : collider_points(world.input.colliders[c], 0))
      state.collider_points.push_back(point);
    state.collider_times.push_back(0);
    state.collider_poses.push_back(collider_pose(world.input.colliders[c], 0));
  }
  state.still_positions = state.later_positions = state.positions;
  grab(world.pins, 0, state);
  start_seams(world.seams, 0, state.positions, state.seam_lengths);
  return state;
}

void update_pins(World& world, double time) {
  std::vector<char> pinned = pinned_vertices(world.pins, world.masses.size(), time);
  if (pinned != world.pinned) build_pinned_parts(world, std::move(pinned));
}

}  // namespace drape
