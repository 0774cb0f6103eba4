// Fig. 6 of the paper: what the elastic response of one step costs by the size of the mesh, for each model.

#include <fmt/format.h>

#include <memory>
#include <numeric>

#include "core/file.h"
#include "core/parallel.h"
#include "elastic_timing.h"
#include "machine.h"
#include "svg_plot.h"

namespace drape::bench {
namespace {

constexpr double micro = 1e6;
constexpr double paper_milliseconds = 13.53;  // Fig. 1: 5k points, one step, on a core of 2008
constexpr int paper_points = 71;
constexpr std::array<int, 6> grids = {32, paper_points, 141, 224, 316, 707};

struct Row {
  std::string model;
  double points, triangles, clusters, model_bytes, scratch_bytes;
  Least least;
};

// Own and outer clusters, fibres and integration: what the paper's model does in a step.
double pass_seconds(const Least& least) {
  double sum = 0;
  for (const Stage stage : {prediction, bending, fibres, membrane, velocities}) sum += least.stages[stage];
  return sum;
}

HangingSheet grid_sheet(int points) {
  return hanging_sheet(points, (points - 1) / double(paper_points - 1), {});
}

Row row_of(const ElasticRun& run, const HangingSheet& hanging) {
  const auto number = [](std::size_t count) { return static_cast<double>(count); };
  return {std::string(run.name()),
          number(hanging.masses.size()),
          number(hanging.sheet.triangles.size()),
          number(run.clusters()),
          number(run.model_bytes()),
          number(run.scratch_bytes()),
          run.least()};
}

// The models by turns, so that whatever else the machine does for a while falls on all of them.
std::vector<Row> time_grid(int points) {
  constexpr int turns = 6;
  constexpr double seconds_a_turn = 0.15;
  const HangingSheet hanging = grid_sheet(points);
  std::vector<std::unique_ptr<ElasticRun>> runs;
  runs.push_back(std::make_unique<ShapeMatchingRun>(hanging));
  runs.push_back(std::make_unique<MassSpringRun>(hanging));
  runs.push_back(std::make_unique<AveragedRun>(hanging));
  for (int turn = 0; turn < turns; ++turn)
    for (const auto& run : runs) run->run(seconds_a_turn);
  std::vector<Row> rows;
  for (const auto& run : runs) rows.push_back(row_of(*run, hanging));
  return rows;
}

std::string model_table(const std::vector<Row>& rows) {
  std::string table = fmt::format("{:>8} {:>9}  {:15} {:>10} {:>12} {:>15}\n", "points", "triangles", "model",
                                  "us a step", "ns a cluster", "to mass_spring");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    const double reference = rows[i - i % 3 + 1].least.cpu;
    table += fmt::format("{:8.0f} {:9.0f}  {:15} {:10.1f} {:12.1f} {:15.2f}\n", row.points, row.triangles,
                         row.model, micro * row.least.cpu, 1e9 * row.least.cpu / row.clusters,
                         row.least.cpu / reference);
  }
  return table;
}

std::string stage_table(const std::vector<Row>& rows) {
  std::string table = fmt::format("{:>8}", "points");
  for (const auto& name : stage_names) table += fmt::format(" {:>10}", name);
  table += fmt::format(" {:>10} {:>10} {:>12}\n", "conversion", "pass", "ns a cluster");
  for (std::size_t i = 0; i < rows.size(); i += 3) {
    const Least& least = rows[i].least;
    const double known = std::accumulate(least.stages.begin(), least.stages.end(), 0.0),
                 pass = pass_seconds(least);
    table += fmt::format("{:8.0f}", rows[i].points);
    for (const double seconds : least.stages) table += fmt::format(" {:10.1f}", micro * seconds);
    table += fmt::format(" {:10.1f} {:10.1f} {:12.1f}\n", micro * (least.cpu - known), micro * pass,
                         1e9 * pass / rows[i].clusters);
  }
  return table;
}

struct Fit {
  double slope, r_squared;
};

// Least squares of milliseconds over thousands of points.
Fit linear_fit(const std::vector<std::array<double, 2>>& points) {
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  const auto n = static_cast<double>(points.size());
  for (const auto& point : points) x += point[0] / n, y += point[1] / n;
  for (const auto& point : points) {
    xx += (point[0] - x) * (point[0] - x);
    xy += (point[0] - x) * (point[1] - y);
    yy += (point[1] - y) * (point[1] - y);
  }
  return {xy / xx, xy * xy / (xx * yy)};
}

// Of every third row from `first` on: thousands of points and milliseconds.
std::vector<std::array<double, 2>> curve(const std::vector<Row>& rows, std::size_t first,
                                         double most_points) {
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = first; i < rows.size(); i += 3)
    if (rows[i].points < most_points) points.push_back({rows[i].points / 1000, 1000 * rows[i].least.cpu});
  return points;
}

std::string fits(const std::vector<Row>& rows, double most_points) {
  const double reference = linear_fit(curve(rows, 1, most_points)).slope;
  std::string text;
  for (std::size_t model = 0; model < 3; ++model) {
    const Fit fit = linear_fit(curve(rows, model, most_points));
    text += fmt::format(
        "up to {:6.0f} points  {:15} {:.4f} ms per 1000 points, R2 {:.5f}, {:.2f} of mass_spring's\n",
        most_points, rows[model].model, fit.slope, fit.r_squared, fit.slope / reference);
  }
  return text;
}

std::string against_paper(const std::vector<Row>& rows) {
  const Least& least = rows[3].least;
  const double step = 1000 * least.cpu, pass = 1000 * pass_seconds(least);
  return fmt::format(
      "71 x 71, the mesh of Fig. 1: the paper's {} ms are {:.0f} times the {:.3f} ms of a whole step,\n"
      "{:.0f} times the {:.3f} ms of the pass (clusters, fibres and integration)\n",
      paper_milliseconds, paper_milliseconds / step, step, paper_milliseconds / pass, pass);
}

std::string memory(const std::vector<Row>& rows) {
  std::string text;
  for (std::size_t i = 3; i < 6; ++i)
    text += fmt::format("{:15} {:5.0f} bytes a point: {:.0f} the model, {:.0f} its scratch\n", rows[i].model,
                        (rows[i].model_bytes + rows[i].scratch_bytes) / rows[i].points,
                        rows[i].model_bytes / rows[i].points, rows[i].scratch_bytes / rows[i].points);
  return text;
}

void run_with(int threads, ElasticRun& run) {
  constexpr double seconds_a_turn = 0.25;
  const ThreadLimit limit(threads);
  run.run(seconds_a_turn);
}

// Wall time tells of threads only while nothing else runs, and the turns give it several chances; the share
// of the work that is left to the first thread tells more of a busy machine.
std::string two_threads(int points) {
  constexpr int turns = 8;
  const HangingSheet hanging = grid_sheet(points);
  ShapeMatchingRun one(hanging), two(hanging);
  for (int turn = 0; turn < turns; ++turn) run_with(1, one), run_with(2, two);
  const Least &alone = one.least(), &both = two.least();
  return fmt::format(
      "{:8} points: {:8.1f} us with 1 thread, {:8.1f} us with 2 ({:.2f} times as fast; CPU time of the first "
      "{:8.1f} us)\n",
      points * points, micro * alone.wall, micro * both.wall, alone.wall / both.wall, micro * both.cpu);
}

std::string csv(const std::vector<Row>& rows) {
  std::string text = "model,points,triangles,clusters,step_us,model_bytes,scratch_bytes";
  for (const auto& name : stage_names) text += fmt::format(",{}_us", name);
  for (const Row& row : rows) {
    text += fmt::format("\n{},{},{},{},{:.2f},{},{}", row.model, row.points, row.triangles, row.clusters,
                        micro * row.least.cpu, row.model_bytes, row.scratch_bytes);
    for (const double seconds : row.least.stages)
      text += row.model == "shape_matching" ? fmt::format(",{:.2f}", micro * seconds) : ",";
  }
  return text + "\n";
}

std::string plot(const std::vector<Row>& rows) {
  constexpr double all = 1e9;
  return to_svg({"Elastic response of one step, one thread",
                 {"points of the mesh, thousands"},
                 {"CPU time, ms"},
                 {{"mass_spring (Bridson, Marino, Fedkiw 2003)", "#c23b22", curve(rows, 1, all)},
                  {"shape_matching (the default)", "#1f5fa8", curve(rows, 0, all)},
                  {"averaged (the paper's own form)", "#3a8f3a", curve(rows, 2, all)}}});
}

std::vector<Row> time_grids() {
  const ThreadLimit limit(1);
  std::vector<Row> rows;
  for (const int points : grids) {
    const std::vector<Row> more = time_grid(points);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

void report() {
  fmt::print("Elastic response of one step (Fig. 6), least CPU time of a thread, no contact\n{}\n\n",
             machine_name());
  const std::vector<Row> rows = time_grids();
  fmt::print("{}\nshape_matching by stage, us\n{}\n", model_table(rows), stage_table(rows));
  fmt::print("{}{}\n{}\n", fits(rows, 1e5), fits(rows, 1e6), against_paper(rows));
  fmt::print("at {:.0f} points\n{}\n", rows[3].points, memory(rows));
  fmt::print("wall time of a step of shape_matching\n{}{}", two_threads(224), two_threads(316));
  write_file(DRAPE_SOURCE_DIR "/out/bench/elastic.csv", csv(rows));
  write_file(DRAPE_SOURCE_DIR "/out/bench/elastic.svg", plot(rows));
}

}  // namespace
}  // namespace drape::bench

int main() { drape::bench::report(); }
