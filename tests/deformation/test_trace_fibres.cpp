#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "deformation/fibres.h"
#include "sheets.h"

namespace drape {
namespace {

using test::sheet_of;
using Fibres = std::vector<std::vector<int>>;

std::vector<TriangleMesh> many_meshes() {
  return {make_grid({1, 1}, {9, 7}),
          test::jittered_grid(12),
          make_sphere(1, 16, 9),
          test::tetrahedron(),
          test::fan(5),
          make_capsule({0, 0, 0}, {0, 1, 0}, 0.3, 12, 5)};
}

TEST(TraceFibres, EveryEdgeIsInExactlyOne) {
  for (const TriangleMesh& mesh : many_meshes()) {
    const Sheet sheet = sheet_of(mesh);
    std::map<std::array<int, 2>, int> uses;
    for (const std::vector<int>& fibre : trace_fibres(sheet))
      for (std::size_t i = 0; i + 1 < fibre.size(); ++i)
        ++uses[{std::min(fibre[i], fibre[i + 1]), std::max(fibre[i], fibre[i + 1])}];
    ASSERT_EQ(uses.size(), sheet.topology.edges.size());
    for (const Edge& edge : sheet.topology.edges) EXPECT_EQ(uses[edge.vertices], 1);
  }
}

TEST(TraceFibres, NoFibreMeetsItself) {
  for (const TriangleMesh& mesh : many_meshes())
    for (const std::vector<int>& fibre : trace_fibres(sheet_of(mesh))) {
      EXPECT_GE(fibre.size(), 2u);
      EXPECT_EQ(std::set<int>(fibre.begin(), fibre.end()).size(), fibre.size());
    }
}

TEST(TraceFibres, NoFibreTurnsByMoreThan45Degrees) {
  for (const TriangleMesh& mesh : many_meshes())
    for (const std::vector<int>& fibre : trace_fibres(sheet_of(mesh)))
      for (std::size_t i = 0; i + 2 < fibre.size(); ++i) {
        const Vec3 first = mesh.positions[fibre[i + 1]] - mesh.positions[fibre[i]];
        const Vec3 second = mesh.positions[fibre[i + 2]] - mesh.positions[fibre[i + 1]];
        EXPECT_GE(first.normalized().dot(second.normalized()), std::sqrt(0.5) - 1e-8);
      }
}

// What a fibre of a grid of `points` a row follows: 1 a row, `points` a column, points + 1 a diagonal; 0
// none.
int stride(const std::vector<int>& fibre) {
  const int first = std::abs(fibre[1] - fibre[0]);
  for (std::size_t i = 0; i + 1 < fibre.size(); ++i)
    if (std::abs(fibre[i + 1] - fibre[i]) != first) return 0;
  return first;
}

TEST(TraceFibres, OnAGridTheyAreRowsColumnsAndDiagonals) {
  const int columns = 9, rows = 6;
  std::map<int, std::vector<std::size_t>> lengths;
  for (const std::vector<int>& fibre : trace_fibres(sheet_of(make_grid({0.8, 0.5}, {columns, rows}))))
    lengths[stride(fibre)].push_back(fibre.size());
  EXPECT_EQ(lengths.count(0), 0u);
  EXPECT_EQ(lengths[1], std::vector<std::size_t>(rows, columns));
  EXPECT_EQ(lengths[columns], std::vector<std::size_t>(columns, rows));
  std::vector<std::size_t>& diagonals = lengths[columns + 1];
  std::sort(diagonals.begin(), diagonals.end());
  // Two of each length up to the full ones, of which there are columns - rows + 1.
  EXPECT_EQ(diagonals, (std::vector<std::size_t>{2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 6, 6}));
}

TEST(TraceFibres, LoopsRoundASphereAreCut) {
  const TriangleMesh sphere = make_sphere(1, 16, 9);
  int equator = 0;
  for (const std::vector<int>& fibre : trace_fibres(sheet_of(sphere)))
    if (std::all_of(fibre.begin(), fibre.end(),
                    [&](int v) { return std::abs(sphere.positions[v].y()) < 1e-12; }))
      equator += static_cast<int>(fibre.size()) - 1;
  EXPECT_TRUE(equator == 0 || equator == 16);
}

TEST(TraceFibres, EdgesThatBendMoreThanAllowedEndTheFibre) {
  // Three triangles round the middle of a tetrahedron's edges: no two edges at a point are near straight.
  for (const std::vector<int>& fibre : trace_fibres(sheet_of(test::tetrahedron())))
    EXPECT_EQ(fibre.size(), 2u);
}

// The vertices of one lane of a group, less what fills it up.
std::vector<int> chain_of(const FibreStage& stage, std::size_t group, int lane, int filler) {
  std::vector<int> chain;
  for (std::size_t row = stage.row_begin[group]; row < stage.row_begin[group + 1]; ++row) {
    const int vertex = stage.vertices[row].vertex(lane);
    if (vertex != filler && (chain.empty() || chain.back() != vertex)) chain.push_back(vertex);
  }
  return chain;
}

TEST(TraceFibres, AStageHoldsEachFibreOnce) {
  for (const TriangleMesh& mesh : many_meshes()) {
    const Sheet sheet = sheet_of(mesh);
    const FibreStage stage = build_fibres(sheet, std::vector<double>(sheet.topology.edges.size(), 1), 0.01);
    Fibres held, traced = trace_fibres(sheet);
    for (std::size_t group = 0; group + 1 < stage.row_begin.size(); ++group)
      for (int lane = 0; lane < Lanes::count; ++lane) {
        held.push_back(chain_of(stage, group, lane, static_cast<int>(mesh.positions.size())));
        if (held.back().empty()) held.pop_back();
      }
    std::sort(held.begin(), held.end());
    std::sort(traced.begin(), traced.end());
    EXPECT_EQ(held, traced);
  }
}

TEST(TraceFibres, AStageHoldsLengthsAndCompliancesOfTheEdges) {
  const double step = 0.01;
  const Sheet sheet = sheet_of(test::jittered_grid(8));
  std::vector<double> stiffnesses;
  for (std::size_t e = 0; e < sheet.topology.edges.size(); ++e)
    stiffnesses.push_back(1.0 + static_cast<double>(e));
  const FibreStage stage = build_fibres(sheet, stiffnesses, step);
  int edges = 0;
  for (std::size_t group = 0; group + 1 < stage.row_begin.size(); ++group)
    for (std::size_t row = stage.row_begin[group] + 1; row < stage.row_begin[group + 1]; ++row)
      for (int lane = 0; lane < Lanes::count; ++lane) {
        const int a = stage.vertices[row - 1].vertex(lane), b = stage.vertices[row].vertex(lane);
        if (a == b) continue;
        const auto edge =
            std::find_if(sheet.topology.edges.begin(), sheet.topology.edges.end(), [&](const Edge& e) {
              return e.vertices == std::array{std::min(a, b), std::max(a, b)};
            });
        const auto index = static_cast<std::size_t>(edge - sheet.topology.edges.begin());
        const double compliance = 1 / (stiffnesses[index] * step * step);
        EXPECT_FLOAT_EQ(stage.rest_lengths[row].values[lane], static_cast<float>(rest_length(sheet, *edge)));
        EXPECT_FLOAT_EQ(stage.compliances[row].values[lane], static_cast<float>(compliance));
        ++edges;
      }
  EXPECT_EQ(edges, static_cast<int>(sheet.topology.edges.size()));
}

TEST(TraceFibres, NoTwoFibresOfAColorShareAVertex) {
  const TriangleMesh mesh = make_sphere(1, 12, 7);
  const Sheet sheet = sheet_of(mesh);
  const FibreStage stage = build_fibres(sheet, std::vector<double>(sheet.topology.edges.size(), 1), 0.01);
  for (std::size_t color = 0; color + 1 < stage.color_begin.size(); ++color) {
    std::set<int> seen;
    for (std::size_t group = stage.color_begin[color]; group < stage.color_begin[color + 1]; ++group)
      for (int lane = 0; lane < Lanes::count; ++lane)
        for (const int v : chain_of(stage, group, lane, static_cast<int>(mesh.positions.size())))
          EXPECT_TRUE(seen.insert(v).second);
  }
}

}  // namespace
}  // namespace drape
