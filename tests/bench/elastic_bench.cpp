// What the elastic part costs, and what it would cost in float.

#include <benchmark/benchmark.h>

#include "core/parallel.h"
#include "deformation/elastic_model.h"
#include "mesh/primitives.h"

namespace drape {
namespace {

Sheet grid_sheet(int points) {
  const TriangleMesh mesh = make_grid({1, 1}, {points, points});
  Sheet sheet{mesh.positions, mesh.triangles, std::vector<int>(mesh.triangles.size(), 0), {{}}, {}};
  sheet.topology = build_topology(static_cast<int>(mesh.positions.size()), mesh.triangles);
  return sheet;
}

template <typename Scalar>
MatchConstants<Scalar> converted(const MatchConstants<double>& c) {
  const auto as = [](double value) { return static_cast<Scalar>(value); };
  return {as(c.q1x), as(c.q1y), as(c.q2x),    as(c.q2y),   as(c.q3y),
          as(c.k1),  as(c.k2),  as(c.share2), as(c.share3)};
}

// The matching alone, scalar code, in the precision asked for: one pull of every own triangle.
template <typename Scalar>
void match_triangles(benchmark::State& state) {
  using Vector = Eigen::Matrix<Scalar, 3, 1>;
  const Sheet sheet = grid_sheet(static_cast<int>(state.range(0)));
  std::vector<MatchConstants<Scalar>> constants;
  std::vector<Vector> x;
  for (const Vec3& p : sheet.rest_positions) x.push_back(p.cast<Scalar>() * Scalar(1.01));
  for (const auto& [a, b, c] : sheet.triangles)
    constants.push_back(converted<Scalar>(match_constants(
        {sheet.rest_positions[a], sheet.rest_positions[b], sheet.rest_positions[c]}, {1, 1, 1})));
  for (auto _ : state) {
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
      const auto& [a, b, c] = sheet.triangles[t];
      const auto displacements = match_displacements(constants[t], x[a], x[b], x[c]);
      x[a] += Scalar(0.1) * displacements[0];
      x[b] += Scalar(0.1) * displacements[1];
      x[c] += Scalar(0.1) * displacements[2];
    }
    benchmark::DoNotOptimize(x.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(sheet.triangles.size()));
}
BENCHMARK(match_triangles<float>)->Arg(71)->Arg(316);
BENCHMARK(match_triangles<double>)->Arg(71)->Arg(316);

// The whole pass of the default model, by the number of threads.
void pull_pass(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(1)));
  const Sheet sheet = grid_sheet(static_cast<int>(state.range(0)));
  const std::vector<double> masses = lumped_masses(sheet);
  const ElasticModel model = build_elastic_model(sheet, masses, std::vector<char>(masses.size(), 0), 0.002);
  std::vector<Vec3> x = sheet.rest_positions;
  FibreScratch scratch;
  for (auto _ : state) pull_to_goals(model, scratch, x);
  state.SetItemsProcessed(state.iterations() * static_cast<long>(sheet.triangles.size()));
}
BENCHMARK(pull_pass)->Args({71, 1})->Args({71, 2})->Args({224, 1})->Args({224, 2})->UseRealTime();

}  // namespace
}  // namespace drape

BENCHMARK_MAIN();
