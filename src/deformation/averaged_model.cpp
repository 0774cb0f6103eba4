#include "deformation/averaged_model.h"

#include <array>
#include <cassert>

#include "core/parallel.h"
#include "deformation/clusters.h"
#include "deformation/fibres.h"

namespace drape {

static void append_triangle_slots(const Sheet& sheet, AveragedModel& model) {
  std::vector<int> materials;
  const std::vector<std::array<int, 3>> clusters = outer_corners(sheet, materials);
  for (const auto& cluster : clusters)
    model.vertices.insert(model.vertices.end(), cluster.begin(), cluster.end());
  model.rest.resize(clusters.size());
  model.rest_lengths.assign(model.vertices.size(), 0);
}

static void append_fibre_slots(const Sheet& sheet, AveragedModel& model) {
  const std::vector<Vec3>& x = sheet.rest_positions;
  model.fibre_begin = {model.vertices.size()};
  for (const std::vector<int>& fibre : trace_fibres(sheet)) {
    model.vertices.insert(model.vertices.end(), fibre.begin(), fibre.end());
    for (std::size_t i = 0; i + 1 < fibre.size(); ++i)
      model.rest_lengths.push_back((x[fibre[i + 1]] - x[fibre[i]]).norm());
    model.rest_lengths.push_back(0);
    model.fibre_begin.push_back(model.vertices.size());
  }
}

static std::size_t cluster_count(const AveragedModel& model, std::size_t vertex) {
  return model.incidence.begin[vertex + 1] - model.incidence.begin[vertex];
}

// Points of no cluster (none on a mesh whose points all have an edge) weigh nothing.
static std::vector<double> cluster_weights(const AveragedModel& model, const std::vector<double>& masses) {
  constexpr double pinned_weight = 1e4;
  std::vector<double> weights(masses.size(), 0);
  for (std::size_t v = 0; v < masses.size(); ++v)
    if (const std::size_t count = cluster_count(model, v); count > 0)
      weights[v] = masses[v] / static_cast<double>(count) * (model.pinned[v] ? pinned_weight : 1);
  return weights;
}

static void match_rest_shapes(const Sheet& sheet, AveragedModel& model) {
  for (std::size_t c = 0; c < model.rest.size(); ++c) {
    const int* v = &model.vertices[3 * c];
    const std::vector<Vec3>& x = sheet.rest_positions;
    const std::vector<double>& weights = model.weights;
    model.rest[c] =
        match_constants({x[v[0]], x[v[1]], x[v[2]]}, {weights[v[0]], weights[v[1]], weights[v[2]]});
  }
}

AveragedModel build_averaged_model(const Sheet& sheet, const std::vector<double>& masses,
                                   const std::vector<char>& pinned, double alpha) {
  assert(alpha > 0 && alpha <= 1);
  AveragedModel model{};
  model.alpha = alpha;
  model.pinned = pinned;
  append_triangle_slots(sheet, model);
  append_fibre_slots(sheet, model);
  model.incidence = build_incidence(static_cast<int>(masses.size()), model.vertices);
  model.weights = cluster_weights(model, masses);
  match_rest_shapes(sheet, model);
  return model;
}

static void match_triangle(const AveragedModel& model, std::size_t cluster, const std::vector<Vec3>& x,
                           std::vector<Vec3>& displacements) {
  const int* v = &model.vertices[3 * cluster];
  const auto matched = match_displacements(model.rest[cluster], x[v[0]], x[v[1]], x[v[2]]);
  for (int i = 0; i < 3; ++i) displacements[3 * cluster + i] = matched[i];
}

// The point at `length` from `from` towards `to` (Fig. 4); `from` itself where there is no direction.
static Vec3 walk_towards(const Vec3& from, const Vec3& to, double length) {
  const Vec3 edge = to - from;
  const double distance = edge.norm();
  return distance > 0 ? Vec3(from + length / distance * edge) : from;
}

// Section 4.2: the mean of two sweeps, each from where the fibre's one end is towards the other.
static void sweep_fibre(const AveragedModel& model, std::size_t begin, std::size_t end,
                        const std::vector<Vec3>& x, std::vector<Vec3>& displacements) {
  const auto position = [&](std::size_t slot) -> const Vec3& { return x[model.vertices[slot]]; };
  Vec3 goal = position(begin);
  displacements[begin] = Vec3::Zero();
  for (std::size_t slot = begin + 1; slot < end; ++slot) {
    goal = walk_towards(goal, position(slot), model.rest_lengths[slot - 1]);
    displacements[slot] = 0.5 * (goal - position(slot));
  }
  goal = position(end - 1);
  for (std::size_t slot = end - 1; slot-- > begin;) {
    goal = walk_towards(goal, position(slot), model.rest_lengths[slot]);
    displacements[slot] += 0.5 * (goal - position(slot));
  }
}

// "Translated such that they sum to 0" (4.2). What keeps momentum is the sum weighted as the average will be,
// with m_i / M_i.
static void centre_fibre(const AveragedModel& model, std::size_t begin, std::size_t end,
                         std::vector<Vec3>& displacements) {
  Vec3 sum = Vec3::Zero();
  double total = 0;
  for (std::size_t slot = begin; slot < end; ++slot) {
    const double weight = model.weights[model.vertices[slot]];
    sum += weight * displacements[slot];
    total += weight;
  }
  const Vec3 mean = sum / total;
  for (std::size_t slot = begin; slot < end; ++slot) displacements[slot] -= mean;
}

// The goal displacements of all clusters at x*.
static void find_goals(const AveragedModel& model, const std::vector<Vec3>& x,
                       std::vector<Vec3>& displacements) {
  constexpr std::size_t triangle_block = 256, fibre_block = 8;
  displacements.resize(model.vertices.size());
  parallel_for_each(model.rest.size(), triangle_block,
                    [&](std::size_t cluster) { match_triangle(model, cluster, x, displacements); });
  parallel_for_each(model.fibre_begin.size() - 1, fibre_block, [&](std::size_t fibre) {
    const std::size_t begin = model.fibre_begin[fibre], end = model.fibre_begin[fibre + 1];
    sweep_fibre(model, begin, end, x, displacements);
    centre_fibre(model, begin, end, displacements);
  });
}

void pull_averaged(const AveragedModel& model, AveragedScratch& scratch, std::vector<Vec3>& x) {
  constexpr std::size_t block = 512;
  find_goals(model, x, scratch.displacements);
  parallel_for_each(x.size(), block, [&](std::size_t v) {
    const std::size_t count = cluster_count(model, v);
    if (model.pinned[v] || count == 0) return;
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = model.incidence.begin[v]; i < model.incidence.begin[v + 1]; ++i)
      sum += scratch.displacements[model.incidence.slots[i]];
    x[v] += model.alpha / static_cast<double>(count) * sum;
  });
}

}  // namespace drape
