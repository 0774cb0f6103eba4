#include "deformation/fibres.h"

#include <algorithm>
#include <array>

#include "core/parallel.h"

namespace drape {

// The stiffness in N/m of an edge as a bar: its material's tension per width over the width that its
// triangles give it (each triangle's area is shared by three edges).
static double edge_stiffness(const Sheet& sheet, const Edge& edge, double length) {
  double stiffness = 0;
  for (const int triangle : edge.triangles)
    if (triangle >= 0)
      stiffness += sheet.materials[sheet.triangle_materials[triangle]].stretch_stiffness *
                   rest_area(sheet, triangle) / (3 * length * length);
  return stiffness;
}

static const Edge& edge_between(const Topology& topology, int a, int b) {
  const std::array<int, 2> wanted = {std::min(a, b), std::max(a, b)};
  return *std::lower_bound(topology.edges.begin(), topology.edges.end(), wanted,
                           [](const Edge& edge, const auto& key) { return edge.vertices < key; });
}

static void append_fibre(const Sheet& sheet, const std::vector<int>& fibre, double step, FibreStage& stage) {
  stage.vertices.insert(stage.vertices.end(), fibre.begin(), fibre.end());
  stage.vertex_begin.push_back(stage.vertices.size());
  for (std::size_t i = 0; i + 1 < fibre.size(); ++i) {
    const double length = (sheet.rest_positions[fibre[i + 1]] - sheet.rest_positions[fibre[i]]).norm();
    const double stiffness =
        edge_stiffness(sheet, edge_between(sheet.topology, fibre[i], fibre[i + 1]), length);
    stage.rest_lengths.push_back(length);
    stage.compliances.push_back(1 / (stiffness * step * step));
  }
}

FibreStage build_fibres(const Sheet& sheet, double step) {
  const std::vector<std::vector<int>> fibres = trace_fibres(sheet);
  Coloring coloring = color_elements(static_cast<int>(sheet.rest_positions.size()), fibres);
  FibreStage stage;
  stage.color_begin = std::move(coloring.color_begin);
  for (const int i : coloring.order) append_fibre(sheet, fibres[i], step, stage);
  return stage;
}

namespace {

// One fibre's share of the stage and of the scratch.
struct Fibre {
  const int* vertices;
  std::size_t edges;
  const double* rest_lengths;
  const double* compliances;
  Vec3* directions;
  double* diagonal;
  double* tension;
};

Fibre fibre_at(const FibreStage& stage, FibreScratch& scratch, std::size_t f) {
  const std::size_t first_vertex = stage.vertex_begin[f], first_edge = first_vertex - f;
  return {&stage.vertices[first_vertex],   stage.vertex_begin[f + 1] - first_vertex - 1,
          &stage.rest_lengths[first_edge], &stage.compliances[first_edge],
          &scratch.directions[first_edge], &scratch.diagonal[first_edge],
          &scratch.tension[first_edge]};
}

// The tridiagonal system, eliminated downward as it is set up.
void eliminate(const Fibre& fibre, const std::vector<double>& inverse_masses, const std::vector<Vec3>& x) {
  for (std::size_t i = 0; i < fibre.edges; ++i) {
    const int a = fibre.vertices[i], b = fibre.vertices[i + 1];
    const Vec3 edge = x[b] - x[a];
    const double length = edge.norm();
    fibre.directions[i] = length > 0 ? Vec3(edge / length) : Vec3(Vec3::Zero());
    fibre.diagonal[i] = inverse_masses[a] + inverse_masses[b] + fibre.compliances[i];
    fibre.tension[i] = length - fibre.rest_lengths[i];
    if (i == 0) continue;
    const double coupling = -inverse_masses[a] * fibre.directions[i - 1].dot(fibre.directions[i]);
    const double factor = coupling / fibre.diagonal[i - 1];
    fibre.diagonal[i] -= factor * coupling;
    fibre.tension[i] -= factor * fibre.tension[i - 1];
  }
}

void substitute_back(const Fibre& fibre, const std::vector<double>& inverse_masses) {
  for (std::size_t i = fibre.edges; i-- > 0;) {
    if (i + 1 < fibre.edges) {
      const double coupling =
          -inverse_masses[fibre.vertices[i + 1]] * fibre.directions[i].dot(fibre.directions[i + 1]);
      fibre.tension[i] -= coupling * fibre.tension[i + 1];
    }
    fibre.tension[i] /= fibre.diagonal[i];
  }
}

void apply_tension(const Fibre& fibre, const std::vector<double>& inverse_masses, std::vector<Vec3>& x) {
  for (std::size_t i = 0; i < fibre.edges; ++i) {
    const int a = fibre.vertices[i], b = fibre.vertices[i + 1];
    x[a] += inverse_masses[a] * fibre.tension[i] * fibre.directions[i];
    x[b] -= inverse_masses[b] * fibre.tension[i] * fibre.directions[i];
  }
}

}  // namespace

void pull_fibres(const FibreStage& stage, const std::vector<double>& inverse_masses, FibreScratch& scratch,
                 std::vector<Vec3>& x) {
  scratch.directions.resize(stage.rest_lengths.size());
  scratch.diagonal.resize(stage.rest_lengths.size());
  scratch.tension.resize(stage.rest_lengths.size());
  constexpr std::size_t block = 4;
  for (std::size_t color = 0; color + 1 < stage.color_begin.size(); ++color) {
    const std::size_t begin = stage.color_begin[color];
    parallel_for_each(stage.color_begin[color + 1] - begin, block, [&](std::size_t i) {
      const Fibre fibre = fibre_at(stage, scratch, begin + i);
      eliminate(fibre, inverse_masses, x);
      substitute_back(fibre, inverse_masses);
      apply_tension(fibre, inverse_masses, x);
    });
  }
}

}  // namespace drape
