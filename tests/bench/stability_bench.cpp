// Stability, section 6.1 of the paper: how long a step each model takes at which stretch of a hanging sheet.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/file.h"
#include "deformation/elastic_model.h"
#include "deformation/mass_spring.h"
#include "hanging_motion.h"
#include "machine.h"
#include "svg_plot.h"

namespace drape::bench {
namespace {

constexpr int points = 32;
constexpr double milli = 1e3;

struct Row {
  std::string model;
  double stiffness;  // N/m
  double step;       // s: the one taken; of mass_spring, the largest stable one
  double bound;      // s: what the model allows by itself
  Stretch stretch;
  double speed;  // m/s, left after settling
  bool stable;
};

// The default but for how it stretches; shear in the default's proportion.
ElasticMaterial material_of_stiffness(double stiffness) {
  ElasticMaterial material;
  const double share = stiffness / material.stretch_stiffness[0];
  for (double& k : material.stretch_stiffness) k *= share;
  material.shear_stiffness *= share;
  return material;
}

// By halves between the bound, which is stable, and four times that, to one percent.
double largest_stable_step(const HangingSheet& hanging, double bound) {
  double stable = bound, unstable = 4 * bound;
  while (unstable > 1.01 * stable) {
    const double middle = 0.5 * (stable + unstable);
    (stays_bounded(hanging, mass_spring_stepper(hanging, middle)) ? stable : unstable) = middle;
  }
  return stable;
}

Row mass_spring_row(double stiffness) {
  const HangingSheet hanging = hanging_sheet(points, 1, material_of_stiffness(stiffness));
  const double bound = build_mass_spring(hanging.sheet, hanging.masses, hanging.pinned).stable_step;
  const Motion rest = settle(hanging, mass_spring_stepper(hanging, bound));
  const bool stable = stays_bounded(hanging, mass_spring_stepper(hanging, bound));
  return {"mass_spring",
          stiffness,
          largest_stable_step(hanging, bound),
          bound,
          stretch_of(hanging, rest.positions),
          largest_speed(rest),
          stable};
}

Row shape_matching_row(const HangingSheet& hanging, double step) {
  const double own =
      std::min(0.002, longest_elastic_step(hanging.sheet));  // the default of a scene's largest step
  const Motion rest = settle(hanging, shape_matching_stepper(hanging, step));
  const bool stable = stays_bounded(hanging, shape_matching_stepper(hanging, step));
  return {"shape_matching",
          hanging.sheet.materials[0].stretch_stiffness[0],
          step,
          own,
          stretch_of(hanging, rest.positions),
          largest_speed(rest),
          stable};
}

std::vector<Row> mass_spring_rows() {
  std::vector<Row> rows;
  for (const double stiffness : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 1000.0, 5000.0, 20000.0})
    rows.push_back(mass_spring_row(stiffness));
  return rows;
}

std::vector<Row> shape_matching_rows() {
  const HangingSheet hanging = hanging_sheet(points, 1, {});
  std::vector<Row> rows;
  for (const double step : {0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 1.0 / 30})
    rows.push_back(shape_matching_row(hanging, step));
  return rows;
}

// The largest stable step of mass_spring at that p99 stretch, on straight lines between its rows in the plot.
std::optional<double> step_at_stretch(const std::vector<Row>& rows, double p99) {
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const double more = std::log(rows[i].stretch.p99 - 1), less = std::log(rows[i + 1].stretch.p99 - 1);
    const double share = (more - std::log(p99 - 1)) / (more - less);
    if (share >= 0 && share <= 1) return rows[i].step * std::pow(rows[i + 1].step / rows[i].step, share);
  }
  return {};
}

std::string mass_spring_table(const std::vector<Row>& rows) {
  std::string table = "mass_spring: stretch at rest and the largest stable step\n";
  table += fmt::format("{:>8} {:>8} {:>8} {:>10} {:>9} {:>6} {:>10}\n", "N/m", "p99", "largest", "stable ms",
                       "bound ms", "ratio", "speed m/s");
  for (const Row& row : rows)
    table += fmt::format("{:8.0f} {:8.5f} {:8.3f} {:10.4f} {:9.4f} {:6.2f} {:10.1e}{}\n", row.stiffness,
                         row.stretch.p99, row.stretch.largest, milli * row.step, milli * row.bound,
                         row.step / row.bound, row.speed, row.stable ? "" : "  unstable at the bound");
  return table;
}

std::string ratio(const std::vector<Row>& springs, const Row& row) {
  const std::optional<double> step = step_at_stretch(springs, row.stretch.p99);
  return step ? fmt::format("{:16.4f} {:6.1f}", milli * *step, row.step / *step)
              : fmt::format("{:>16} {:>6}", "-", "-");
}

std::string shape_matching_table(const std::vector<Row>& rows, const std::vector<Row>& springs) {
  std::string table = fmt::format(
      "shape_matching, the default material (20000 N/m); the step that it "
      "chooses\nby itself is {:.2f} ms. Last: mass_spring's largest step at the same p99\n",
      milli * rows[0].bound);
  table += fmt::format("{:>8} {:>8} {:>8} {:>8} {:>10} {:>16} {:>6}\n", "step ms", "p99", "largest", "stable",
                       "speed m/s", "mass_spring's ms", "ratio");
  for (const Row& row : rows)
    table += fmt::format("{:8.2f} {:8.5f} {:8.3f} {:>8} {:10.1e} {}\n", milli * row.step, row.stretch.p99,
                         row.stretch.largest, row.stable ? "yes" : "no", row.speed, ratio(springs, row));
  return table;
}

std::string csv(const std::vector<Row>& springs, const std::vector<Row>& matching) {
  std::string text =
      "model,stretch_stiffness,step_ms,own_bound_ms,p99_stretch,largest_stretch,speed,stable\n";
  for (const std::vector<Row>* rows : {&springs, &matching})
    for (const Row& row : *rows)
      text += fmt::format("{},{},{:.5f},{:.5f},{:.6f},{:.6f},{:.3e},{}\n", row.model, row.stiffness,
                          milli * row.step, milli * row.bound, row.stretch.p99, row.stretch.largest,
                          row.speed, row.stable);
  return text;
}

std::vector<std::array<double, 2>> curve(const std::vector<Row>& rows) {
  std::vector<std::array<double, 2>> curve;
  for (const Row& row : rows) curve.push_back({milli * row.step, row.stretch.p99 - 1});
  return curve;
}

std::string plot(const std::vector<Row>& springs, const std::vector<Row>& matching) {
  return to_svg({"Stretch of a hanging sheet of 1024 points against the step",
                 {"step, ms", true},
                 {"p99 stretch less 1", true},
                 {{"mass_spring: the largest stable step, softer to the right", "#c23b22", curve(springs)},
                  {"shape_matching: the default material", "#1f5fa8", curve(matching)}}});
}

void report() {
  fmt::print("A sheet of 32 x 32 points and one metre, held at two corners (section 6.1)\n{}\n\n",
             machine_name());
  const std::vector<Row> springs = mass_spring_rows(), matching = shape_matching_rows();
  fmt::print("{}\n{}", mass_spring_table(springs), shape_matching_table(matching, springs));
  write_file(DRAPE_SOURCE_DIR "/out/bench/stability.csv", csv(springs, matching));
  write_file(DRAPE_SOURCE_DIR "/out/bench/stability.svg", plot(springs, matching));
}

}  // namespace
}  // namespace drape::bench

int main() { drape::bench::report(); }
