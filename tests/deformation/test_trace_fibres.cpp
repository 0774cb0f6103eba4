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

TEST(TraceFibres, AStageHoldsAllFibresWithTheirLengths) {
  const Sheet sheet = sheet_of(test::jittered_grid(8));
  const FibreStage stage = build_fibres(sheet, 0.01);
  ASSERT_EQ(stage.rest_lengths.size(), sheet.topology.edges.size());
  ASSERT_EQ(stage.vertex_begin.size() - 1, trace_fibres(sheet).size());
  for (std::size_t f = 0; f + 1 < stage.vertex_begin.size(); ++f)
    for (std::size_t i = stage.vertex_begin[f]; i + 1 < stage.vertex_begin[f + 1]; ++i) {
      const Vec3 edge = sheet.rest_positions[stage.vertices[i + 1]] - sheet.rest_positions[stage.vertices[i]];
      EXPECT_EQ(stage.rest_lengths[i - f], edge.norm());
    }
}

TEST(TraceFibres, NoTwoFibresOfAColorShareAVertex) {
  const FibreStage stage = build_fibres(sheet_of(make_sphere(1, 12, 7)), 0.01);
  for (std::size_t color = 0; color + 1 < stage.color_begin.size(); ++color) {
    std::set<int> seen;
    for (std::size_t i = stage.vertex_begin[stage.color_begin[color]];
         i < stage.vertex_begin[stage.color_begin[color + 1]]; ++i)
      EXPECT_TRUE(seen.insert(stage.vertices[i]).second);
  }
}

// A bar's stiffness: tension per width, times width over length. All bars of a square sheet, pulled along its
// rows, share its width.
TEST(TraceFibres, ComplianceIsThatOfTheMaterialAndTheStep) {
  const double step = 0.01, stretch_stiffness = 2000;
  const Sheet sheet = sheet_of(test::equilateral_pair(0.1, 0), {.stretch_stiffness = stretch_stiffness});
  const FibreStage stage = build_fibres(sheet, step);
  const double area = std::sqrt(3) / 4 * 0.01;
  const double at_boundary = stretch_stiffness * area / (3 * 0.01);
  std::vector<double> stiffness;
  for (const double compliance : stage.compliances) stiffness.push_back(1 / (compliance * step * step));
  std::sort(stiffness.begin(), stiffness.end());
  ASSERT_EQ(stiffness.size(), 5u);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(stiffness[i], at_boundary, 1e-9 * at_boundary);
  EXPECT_NEAR(stiffness[4], 2 * at_boundary, 1e-9 * at_boundary);
}

}  // namespace
}  // namespace drape
