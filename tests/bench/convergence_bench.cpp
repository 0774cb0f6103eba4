// Does the shape at rest depend on the mesh, or on the step? Sheets that hang, that are clamped along an edge
// and that lie over a ball: points at the same places of the cloth are compared with those of the finest
// regular mesh, in percent of the side. The clamped one has an exact shape too.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "machine.h"
#include "simulation/elastica.h"
#include "simulation/shapes_at_rest.h"

namespace drape {
namespace {

using namespace test;

struct Proof {
  std::string name;
  SimulationInput (*make)(const MeshAndStep&);
  double side;     // m
  Vec3 middle;     // of the square that is compared, in the rest shape
  double seconds;  // to settle
};

std::vector<Vec3> shape_at_rest(const Proof& proof, const MeshAndStep& run) {
  constexpr int samples = 24;
  Simulation simulation(proof.make(run));
  settle(simulation, proof.seconds);
  return sample_square(simulation, proof.side, proof.middle, samples);
}

double lowest(const std::vector<Vec3>& places) {
  return std::ranges::min(places, {}, [](const Vec3& place) { return place.y(); }).y();
}

void print_row(const Proof& proof, const MeshAndStep& run, const std::vector<Vec3>& shape,
               const std::vector<Vec3>& finest) {
  fmt::print("| {} | {}² {} | {:.0f} ms | {:.1f} mm | {:.2f} % | {:.2f} % |\n", proof.name, run.points,
             run.irregular ? "irregular" : "regular", 1000 * run.step, 1000 * lowest(shape),
             100 * rms_distance(shape, finest) / proof.side,
             100 * std::abs(lowest(shape) - lowest(finest)) / proof.side);
  std::fflush(stdout);
}

void compare(const Proof& proof) {
  const std::array<MeshAndStep, 7> runs = {{{128, false, 0.002},
                                            {64, false, 0.002},
                                            {32, false, 0.002},
                                            {64, true, 0.002},
                                            {32, true, 0.002},
                                            {32, false, 0.001},
                                            {32, false, 0.005}}};
  std::vector<Vec3> finest;
  for (const MeshAndStep& run : runs) {
    const std::vector<Vec3> shape = shape_at_rest(proof, run);
    if (finest.empty()) finest = shape;
    print_row(proof, run, shape, finest);
  }
}

}  // namespace
}  // namespace drape

int main() {
  using namespace drape;
  fmt::print(
      "{}\n\n| sheet | points | step | lowest point | shape, against the finest | lowest, against it |\n",
      bench::machine_name());
  fmt::print("|---|---|---|---|---|---|\n");
  compare({"hang", test::hanging_sheet, 1, Vec3::Zero(), 1.5});
  compare({"ball", test::sheet_on_a_ball, 1, Vec3::Zero(), 2});
  compare({"cantilever", test::cantilever, test::overhang, Vec3(test::overhang / 2, 0, 0), 1.5});
  fmt::print(
      "\nThe cantilever's tip by its elastica: {:.1f} mm\n",
      1000 * test::elastica_tip(test::overhang, test::cantilever_rigidity, test::cantilever_density).y);
}
