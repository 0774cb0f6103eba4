#include "deformation/fibres.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/parallel.h"
#include "deformation/coloring.h"
#include "deformation/fibres_kernel.h"

namespace drape {
namespace {

std::size_t edge_between(const Topology& topology, int a, int b) {
  const std::array<int, 2> wanted = {std::min(a, b), std::max(a, b)};
  const auto found = std::lower_bound(topology.edges.begin(), topology.edges.end(), wanted,
                                      [](const Edge& edge, const auto& key) { return edge.vertices < key; });
  return static_cast<std::size_t>(found - topology.edges.begin());
}

double strain_limit(const Sheet& sheet, const Edge& edge) {
  const double limit = material_of(sheet, edge.triangles[0]).strain_limit;
  return limit > 0 ? limit : std::numeric_limits<double>::infinity();
}

// One lane of a group: a fibre, then its last vertex over and over, in edges of no length and no tension.
void fill_lane(const Sheet& sheet, const std::vector<int>& fibre, const std::vector<double>& stiffnesses,
               double step, std::size_t first_row, int lane, FibreStage& stage) {
  for (std::size_t row = first_row; row < stage.vertices.size(); ++row) {
    const std::size_t i = row - first_row;
    stage.vertices[row].set(lane, fibre[std::min(i, fibre.size() - 1)]);
    if (i == 0 || i >= fibre.size()) continue;
    const std::size_t e = edge_between(sheet.topology, fibre[i - 1], fibre[i]);
    const double length = rest_length(sheet, sheet.topology.edges[e]);
    stage.rest_lengths[row].values[lane] = static_cast<float>(length);
    stage.compliances[row].values[lane] = static_cast<float>(1 / (stiffnesses[e] * step * step));
    stage.longest[row].values[lane] =
        static_cast<float>(length * (1 + strain_limit(sheet, sheet.topology.edges[e])));
  }
}

// The fibres of one colour in groups of eight, the long ones together.
void append_color(const Sheet& sheet, std::vector<std::vector<int>> fibres,
                  const std::vector<double>& stiffnesses, double step, FibreStage& stage) {
  std::stable_sort(fibres.begin(), fibres.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  const int filler = static_cast<int>(sheet.rest_positions.size());
  for (std::size_t first = 0; first < fibres.size(); first += Lanes::count) {
    const std::size_t first_row = stage.vertices.size(), rows = first_row + fibres[first].size();
    stage.vertices.resize(rows);
    stage.rest_lengths.resize(rows, LaneRow{});
    stage.compliances.resize(rows, LaneRow{});
    stage.longest.resize(rows, LaneRow{});
    for (int lane = 0; lane < Lanes::count; ++lane) {
      const std::size_t i = first + static_cast<std::size_t>(lane);
      fill_lane(sheet, i < fibres.size() ? fibres[i] : std::vector<int>{filler}, stiffnesses, step, first_row,
                lane, stage);
    }
    stage.row_begin.push_back(rows);
    stage.longest_group = std::max(stage.longest_group, rows - first_row);
  }
  stage.color_begin.push_back(stage.row_begin.size() - 1);
}

}  // namespace

FibreStage build_fibres(const Sheet& sheet, const std::vector<double>& stiffnesses, double step) {
  const std::vector<std::vector<int>> fibres = trace_fibres(sheet);
  const Coloring coloring = color_elements(static_cast<int>(sheet.rest_positions.size()), fibres);
  FibreStage stage;
  stage.color_begin = {0};
  for (std::size_t color = 0; color + 1 < coloring.color_begin.size(); ++color) {
    std::vector<std::vector<int>> of_color;
    for (std::size_t i = coloring.color_begin[color]; i < coloring.color_begin[color + 1]; ++i)
      of_color.push_back(fibres[coloring.order[i]]);
    append_color(sheet, std::move(of_color), stiffnesses, step, stage);
  }
  return stage;
}

// Groups that a thread takes after each other, in the same scratch, which so stays in its caches.
constexpr std::size_t groups_a_block = 2;

static std::size_t largest_block_count(const FibreStage& stage) {
  std::size_t largest = 0;
  for (std::size_t color = 0; color + 1 < stage.color_begin.size(); ++color)
    largest = std::max(largest, stage.color_begin[color + 1] - stage.color_begin[color]);
  return (largest + groups_a_block - 1) / groups_a_block;
}

void load_fibres(const FibreStage& stage, const SplitPoints& start, FibreScratch& scratch) {
  scratch.base.resize(3 * stage.vertices.size());
  scratch.work.resize(largest_block_count(stage) * stage.longest_group * fibre_work_rows);
  parallel_for_each(stage.row_begin.size() - 1, 1, [&](std::size_t group) {
    load_fibre_group<Lanes>(stage, start, group, {}, scratch.base);
  });
}

void pull_fibres(const FibreStage& stage, FibreScratch& scratch, std::vector<Point4>& offsets) {
  for (std::size_t color = 0; color + 1 < stage.color_begin.size(); ++color) {
    const std::size_t first = stage.color_begin[color];
    parallel_blocks(stage.color_begin[color + 1] - first, groups_a_block,
                    [&](std::size_t begin, std::size_t end, std::size_t block) {
                      LaneRow* work = &scratch.work[block * stage.longest_group * fibre_work_rows];
                      for (std::size_t i = begin; i < end; ++i)
                        pull_fibre_group<Lanes>(stage, scratch.base, first + i, {}, work, offsets.data());
                    });
  }
}

}  // namespace drape
