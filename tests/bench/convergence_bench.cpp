// Does the shape at rest depend on the mesh, or on the step? A sheet of a metre that hangs from two corners,
// one that is clamped along an edge and bends under its weight, and one over a ball: points at the same
// places of the cloth are compared with those of the finest regular mesh, as a root mean square in percent of
// the side.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "machine.h"
#include "mesh/primitives.h"
#include "simulation/simulation.h"

namespace drape {
namespace {

constexpr double side = 1;

struct Run {
  int points;
  bool irregular;
  double step;  // seconds, of a frame
};

// Points moved by up to three tenths of an edge, but for those of the rim.
TriangleMesh sheet_mesh(const Run& run) {
  TriangleMesh mesh = make_grid({side, side}, {run.points, run.points});
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> share(-0.3, 0.3);
  const double edge = side / (run.points - 1), rim = side / 2 - 1e-9;
  for (Vec3& x : mesh.positions)
    if (run.irregular && std::abs(x.x()) < rim && std::abs(x.z()) < rim)
      x += edge * Vec3(share(engine), 0, share(engine));
  return mesh;
}

SimulationInput sheet_input(const Run& run, double height) {
  SimulationInput input;
  input.cloths.resize(1);
  ClothInput& cloth = input.cloths[0];
  cloth.name = "sheet";
  cloth.mesh = sheet_mesh(run);
  for (const Vec3& x : cloth.mesh.positions) cloth.start_positions.push_back(x + Vec3(0, height, 0));
  input.frame_duration = input.largest_step = run.step;
  return input;
}

SimulationInput hang(const Run& run) {
  SimulationInput input = sheet_input(run, 0);
  ClothInput& cloth = input.cloths[0];
  for (Vec3& x : cloth.start_positions) x = Vec3(x.x(), x.z(), 0);
  cloth.pins.resize(1);
  cloth.pins[0].vertices = {run.points * (run.points - 1), run.points * run.points - 1};
  return input;
}

// Pinned over the first 1/31 of its length, which is a column of cells of the coarsest mesh.
SimulationInput cantilever(const Run& run) {
  SimulationInput input = sheet_input(run, 0);
  ClothInput& cloth = input.cloths[0];
  cloth.material.elastic.bend_stiffness = {1e-3, 1e-3};
  cloth.pins.resize(1);
  for (std::size_t v = 0; v < cloth.mesh.positions.size(); ++v)
    if (cloth.mesh.positions[v].x() < -side / 2 + side / 31 + 1e-9)
      cloth.pins[0].vertices.push_back(static_cast<int>(v));
  return input;
}

SimulationInput on_a_ball(const Run& run) {
  constexpr double radius = 0.3;
  SimulationInput input = sheet_input(run, radius + 0.006);
  ClothMaterial& material = input.cloths[0].material;
  material.elastic.density = 0.5;
  material.elastic.bend_stiffness = {2e-3, 2e-3};
  material.elastic.shear_stiffness = 200;
  material.thickness = 0.005;
  ColliderInput ball;
  ball.name = "ball";
  ball.shape = SphereShape{radius};
  input.colliders.push_back(ball);
  return input;
}

// Dynamic relaxation (Day 1965): all velocities are taken away whenever the kinetic energy has passed a peak.
void settle(Simulation& simulation, double seconds) {
  double before = 0;
  const int frames = static_cast<int>(std::round(seconds / simulation.input().frame_duration));
  for (int frame = 0; frame < frames; ++frame) {
    const double energy = simulation.advance_frame().kinetic_energy;
    const bool past_a_peak = energy < before;
    before = past_a_peak ? 0 : energy;
    if (!past_a_peak) continue;
    State state = simulation.state();
    for (Vec3& velocity : state.velocities) velocity.setZero();
    simulation.restore(std::move(state));
  }
}

// Where the point of the cloth that rests at `rest` is, by the triangle that it lies in.
Vec3 place_of(const TriangleMesh& mesh, const std::vector<Vec3>& x, const Vec3& rest) {
  double best = -std::numeric_limits<double>::infinity();
  Vec3 place = Vec3::Zero();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 ab = mesh.positions[b] - mesh.positions[a], ac = mesh.positions[c] - mesh.positions[a];
    const Vec3 way = rest - mesh.positions[a];
    const double area = ab.cross(ac).y(), share_b = way.cross(ac).y() / area,
                 share_c = ab.cross(way).y() / area;
    const double inside = std::min({1 - share_b - share_c, share_b, share_c});
    if (inside <= best) continue;
    best = inside;
    place = x[a] + share_b * (x[b] - x[a]) + share_c * (x[c] - x[a]);
  }
  return place;
}

constexpr int samples = 24;  // along each side

std::vector<Vec3> settled_shape(SimulationInput input, double seconds) {
  const TriangleMesh mesh = input.cloths[0].mesh;
  Simulation simulation(std::move(input));
  settle(simulation, seconds);
  std::vector<Vec3> places;
  for (int row = 0; row < samples; ++row)
    for (int column = 0; column < samples; ++column) {
      const auto at = [](int i) { return side * (i / (samples - 1.0) - 0.5); };
      places.push_back(place_of(mesh, simulation.state().positions, Vec3(at(column), 0, at(row))));
    }
  return places;
}

double lowest(const std::vector<Vec3>& places) {
  double least = places[0].y();
  for (const Vec3& place : places) least = std::min(least, place.y());
  return least;
}

double rms_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

void print_row(const std::string& test, const Run& run, const std::vector<Vec3>& shape,
               const std::vector<Vec3>& reference) {
  fmt::print("| {} | {}² {} | {:.0f} ms | {:.4f} m | {:.2f} % | {:.2f} % |\n", test, run.points,
             run.irregular ? "irregular" : "regular", 1000 * run.step, lowest(shape),
             100 * rms_difference(shape, reference) / side,
             100 * std::abs(lowest(shape) - lowest(reference)) / side);
  std::fflush(stdout);
}

// The finest first: what the others are compared with.
void compare(const std::string& test, SimulationInput (*make)(const Run&), double seconds, int finest) {
  const std::array<Run, 6> runs = {Run{finest, false, 0.002},     Run{finest / 2, false, 0.002},
                                   Run{finest / 4, false, 0.002}, Run{finest / 2, true, 0.002},
                                   Run{finest / 4, false, 0.001}, Run{finest / 4, false, 0.005}};
  std::vector<Vec3> reference;
  for (const Run& run : runs) {
    const std::vector<Vec3> shape = settled_shape(make(run), seconds);
    if (reference.empty()) reference = shape;
    print_row(test, run, shape, reference);
  }
}

}  // namespace
}  // namespace drape

int main() {
  using namespace drape;
  fmt::print("{}\n\n| test | points | step | lowest point | shape against the finest | lowest against it |\n",
             bench::machine_name());
  fmt::print("|---|---|---|---|---|---|\n");
  compare("hang", hang, 1.5, 128);
  compare("cantilever", cantilever, 2.5, 128);
  compare("ball", on_a_ball, 2.5, 64);
}
