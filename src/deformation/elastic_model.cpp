#include "deformation/elastic_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "deformation/membrane_material.h"

namespace drape {
namespace {

// The membrane of each triangle, less what its edges carry as bars; and these, in N/m of each edge.
struct Membrane {
  std::vector<Mat3> whole, left;
  std::vector<double> bars;
};

// A bar of stiffness b per area over a triangle of area A is a spring of b A / l2 on the edge.
void split_triangle(const Sheet& sheet, int t, const RestFrame& frame, Membrane& membrane) {
  const std::array<Vec2, 3> edges = {frame.edge1, frame.edge2 - frame.edge1, frame.edge2};
  const Mat3 tensor = membrane_tensor(material_of(sheet, t), frame.warp);
  const BarSplit split =
      split_into_bars(tensor, {edges[0].normalized(), edges[1].normalized(), edges[2].normalized()});
  for (std::size_t k = 0; k < 3; ++k)
    membrane.bars[sheet.topology.triangle_edges[t][k]] += split.bars[k] * frame.area / edges[k].squaredNorm();
  membrane.whole.push_back(tensor);
  membrane.left.push_back(split.rest);
}

Membrane split_membrane(const Sheet& sheet, const std::vector<double>& weights) {
  Membrane membrane;
  membrane.bars.resize(sheet.topology.edges.size(), 0.0);
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t)
    split_triangle(sheet, t, rest_frame(sheet, t, weights), membrane);
  return membrane;
}

// Kelvin-Voigt: a stress of `damping` times stiffness times the rate, over one step.
std::vector<double> damping_times_step(const Sheet& sheet, double step) {
  std::vector<double> result;
  for (const ElasticMaterial& material : sheet.materials) result.push_back(material.damping * step);
  return result;
}

std::vector<Mat3> damped_tensors(const Sheet& sheet, const std::vector<Mat3>& whole) {
  std::vector<Mat3> tensors = whole;
  for (int t = 0; t < static_cast<int>(tensors.size()); ++t) tensors[t] *= material_of(sheet, t).damping;
  return tensors;
}

// A patch of points of which the elements' constants about fill a core's second cache.
constexpr std::size_t largest_patch = 1300;

}  // namespace

// The length that counts of each material's edges: the shortest one, but no less than a quarter of their
// mean, so that one sliver does not make a whole cloth slow.
static std::vector<double> counting_lengths(const Sheet& sheet) {
  constexpr double least_share = 0.25;
  const std::vector<double> means = mean_edge_lengths(sheet);
  std::vector<double> shortest(sheet.materials.size(), std::numeric_limits<double>::infinity());
  for (const Edge& edge : sheet.topology.edges) {
    const int material = sheet.triangle_materials[edge.triangles[0]];
    shortest[material] = std::min(shortest[material], rest_length(sheet, edge));
  }
  for (std::size_t i = 0; i < means.size(); ++i) shortest[i] = std::max(shortest[i], least_share * means[i]);
  return shortest;
}

double longest_elastic_step(const Sheet& sheet) {
  constexpr double edges_crossed = 12, visible_speed = 30, bending_phase = 0.1;
  const std::vector<double> lengths = counting_lengths(sheet);
  double longest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const ElasticMaterial& material = sheet.materials[i];
    const auto speed = [&](const std::array<double, 2>& stiffness) {
      return std::sqrt(std::max(stiffness[0], stiffness[1]) / material.density);
    };
    longest = std::min({longest, edges_crossed * lengths[i] / speed(material.stretch_stiffness),
                        lengths[i] / visible_speed,
                        bending_phase * lengths[i] * lengths[i] / speed(material.bend_stiffness)});
  }
  return longest;
}

ElasticModel build_elastic_model(const Sheet& sheet, const std::vector<double>& masses,
                                 const std::vector<char>& pinned, double gravity, double step) {
  std::vector<double> weights = masses, inverse_masses(masses.size());
  for (std::size_t v = 0; v < masses.size(); ++v) {
    if (pinned[v]) weights[v] *= 1e4;
    inverse_masses[v] = pinned[v] ? 0 : 1 / masses[v];
  }
  const std::vector<int> patches = vertex_patches(sheet.rest_positions, largest_patch);
  const Membrane membrane = split_membrane(sheet, weights);
  ElasticModel model;
  model.step = step;
  model.bending = build_bending(sheet, patches, inverse_masses, step * step, damping_times_step(sheet, step));
  model.membrane = build_membrane(sheet, patches, weights, inverse_masses, {membrane.left, step * step},
                                  {damped_tensors(sheet, membrane.whole), step});
  model.fibres = build_fibres(sheet, membrane.bars, step);
  model.tethers = build_tethers(sheet, masses, pinned, gravity);
  for (const double inverse_mass : inverse_masses)
    model.inverse_masses.push_back({0, 0, 0, static_cast<float>(inverse_mass)});
  const std::size_t patch_count =
      std::max(model.bending.order.patch_count(), model.membrane.order.patch_count());
  model.inverse_masses.resize(masses.size() + fillers_a_patch * patch_count, Point4{});
  return model;
}

void load_elastic(const ElasticModel& model, const std::vector<Vec3>& start, ElasticScratch& scratch) {
  split_points(start, model.inverse_masses.size(), scratch.start);
  load_bending(model.bending, scratch.start, scratch.bending_base);
  load_membrane(model.membrane, scratch.start, scratch.membrane_base);
  load_fibres(model.fibres, scratch.start, scratch.fibres);
  load_tethers(model.tethers, scratch.start, scratch.tether_base);
}

namespace {

constexpr std::size_t points_a_block = 1024;

Point4 as_point(const Vec3& vector, float w) {
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()), static_cast<float>(vector.z()), w};
}

// Fillers have no motion.
void load_motion(const ElasticModel& model, const std::vector<Vec3>& velocities,
                 const std::vector<Vec3>& accelerations, ElasticScratch& scratch) {
  const std::vector<Point4>& still = model.inverse_masses;
  scratch.velocities.resize(still.size());
  scratch.accelerations.resize(still.size());
  parallel_for_each(still.size(), points_a_block, [&](std::size_t v) {
    const bool is_filler = v >= velocities.size();
    scratch.velocities[v] = is_filler ? still[v] : as_point(velocities[v], still[v].w);
    scratch.accelerations[v] = is_filler ? still[v] : as_point(accelerations[v], still[v].w);
  });
}

// Velocities after viscosity, once a step. Membrane frames are those where the step starts.
void damp(const ElasticModel& model, ElasticScratch& scratch) {
  damp_bending(model.bending, scratch.velocities);
  damp_membrane(model.membrane, scratch.membrane_base, scratch.velocities);
}

// Pinned points are where their pins take them.
void move_pinned(const ElasticModel& model, const std::vector<Vec3>& start,
                 const std::vector<Vec3>& positions, ElasticScratch& scratch) {
  for (std::size_t v = 0; v < start.size(); ++v) {
    if (model.inverse_masses[v].w > 0) continue;
    scratch.offsets[v] = as_point(positions[v] - start[v], 0);
  }
}

Vec3 as_vec3(const Point4& point) { return Vec3(point.x, point.y, point.z); }

void unload(const ElasticModel& model, const std::vector<Vec3>& start, const ElasticScratch& scratch,
            std::vector<Vec3>& positions, std::vector<Vec3>& velocities) {
  parallel_for_each(start.size(), points_a_block, [&](std::size_t v) {
    if (model.inverse_masses[v].w > 0) {
      positions[v] = start[v] + as_vec3(scratch.offsets[v]);
      velocities[v] = as_vec3(scratch.velocities[v]);
    } else {
      velocities[v] = (positions[v] - start[v]) / model.step;
    }
  });
}

}  // namespace

void predict_offsets(const ElasticModel& model, ElasticScratch& scratch) {
  const auto step = static_cast<float>(model.step);
  scratch.offsets.resize(scratch.velocities.size());
  parallel_blocks(
      scratch.offsets.size(), points_a_block, [&](std::size_t begin, std::size_t end, std::size_t) {
        const Point4 *velocities = scratch.velocities.data(), *accelerations = scratch.accelerations.data();
        const Point4* still = model.inverse_masses.data();
        Point4* offsets = scratch.offsets.data();
        for (std::size_t v = begin; v < end; ++v) {
          const PointLanes u = add_multiple(load_point(velocities[v]), step, load_point(accelerations[v]));
          store_point(add_multiple(load_point(still[v]), step, u), offsets[v]);
        }
      });
}

void pull_to_goals(const ElasticModel& model, ElasticScratch& scratch) {
  pull_bending(model.bending, scratch.bending_base, scratch.offsets);
  pull_tethers(model.tethers, scratch.tether_base, scratch.offsets);
  pull_fibres(model.fibres, scratch.fibres, scratch.offsets);
  pull_membrane(model.membrane, scratch.membrane_base, scratch.offsets);
}

void update_velocities(const ElasticModel& model, ElasticScratch& scratch) {
  const auto rate = static_cast<float>(1 / model.step);
  parallel_blocks(scratch.offsets.size(), points_a_block,
                  [&](std::size_t begin, std::size_t end, std::size_t) {
                    const Point4* offsets = scratch.offsets.data();
                    Point4* velocities = scratch.velocities.data();
                    for (std::size_t v = begin; v < end; ++v)
                      store_point(scaled(rate, load_point(offsets[v])), velocities[v]);
                  });
}

void advance_elastic(const ElasticModel& model, const std::vector<Vec3>& accelerations,
                     const std::vector<Vec3>& start, ElasticScratch& scratch, std::vector<Vec3>& positions,
                     std::vector<Vec3>& velocities) {
  load_elastic(model, start, scratch);
  load_motion(model, velocities, accelerations, scratch);
  damp(model, scratch);
  predict_offsets(model, scratch);
  move_pinned(model, start, positions, scratch);
  pull_to_goals(model, scratch);
  update_velocities(model, scratch);
  unload(model, start, scratch, positions, velocities);
}

}  // namespace drape
