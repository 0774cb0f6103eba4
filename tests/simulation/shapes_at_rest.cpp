#include "simulation/shapes_at_rest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "mesh/primitives.h"
#include "simulation/scenarios.h"

namespace drape::test {
namespace {

// Points strictly within the square of `side` round `middle`.
void make_irregular(TriangleMesh& mesh, double edge, double side, const Vec3& middle) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> share(-0.3, 0.3);
  for (Vec3& x : mesh.positions)
    if ((x - middle).cwiseAbs().maxCoeff() < 0.5 * side - 1e-9)
      x += edge * Vec3(share(engine), 0, share(engine));
}

ClothInput square_metre(const MeshAndStep& run) {
  ClothInput cloth = sheet(1, run.points, 0);
  if (run.irregular) make_irregular(cloth.mesh, 1.0 / (run.points - 1), 1, Vec3::Zero());
  cloth.start_positions = cloth.mesh.positions;
  cloth.pins.resize(1);
  return cloth;
}

// Clamped up to x = 0, free to x = overhang.
TriangleMesh clamped_strip(const MeshAndStep& run) {
  const double edge = overhang / (run.points - 1);
  TriangleMesh mesh = make_grid({overhang + edge, overhang}, {run.points + 1, run.points});
  for (Vec3& x : mesh.positions) x.x() += (overhang - edge) / 2;
  if (run.irregular) make_irregular(mesh, edge, overhang, Vec3(overhang / 2, 0, 0));
  return mesh;
}

template <typename Picks>
void pin_where(ClothInput& cloth, const Picks& picks) {
  cloth.pins.resize(1);
  for (std::size_t v = 0; v < cloth.mesh.positions.size(); ++v)
    if (picks(cloth.mesh.positions[v])) cloth.pins[0].vertices.push_back(static_cast<int>(v));
}

SimulationInput without_air(ClothInput cloth, double step) {
  SimulationInput input = simulate_alone(std::move(cloth));
  input.self_collision = false;
  input.frame_duration = input.largest_step = step;
  remove_air(input);
  return input;
}

// Shares of the corners of the triangle a, b, c at `point`, all in a plane of equal y.
Vec3 barycentric(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
  const Vec3 ab = b - a, ac = c - a, way = point - a;
  const double area = ab.cross(ac).y(), share_b = way.cross(ac).y() / area,
               share_c = ab.cross(way).y() / area;
  return {1 - share_b - share_c, share_b, share_c};
}

// By the triangle that it lies in, or lies out of the least.
Vec3 place_of(const TriangleMesh& mesh, const std::vector<Vec3>& x, const Vec3& rest) {
  double best = -std::numeric_limits<double>::infinity();
  Vec3 place = Vec3::Zero();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 shares = barycentric(mesh.positions[a], mesh.positions[b], mesh.positions[c], rest);
    if (shares.minCoeff() <= best) continue;
    best = shares.minCoeff();
    place = shares[0] * x[a] + shares[1] * x[b] + shares[2] * x[c];
  }
  return place;
}

}  // namespace

SimulationInput hanging_sheet(const MeshAndStep& run) {
  ClothInput cloth = square_metre(run);
  pin_where(cloth, [](const Vec3& x) { return std::abs(x.x()) > 0.5 - 1e-9 && x.z() > 0.5 - 1e-9; });
  for (Vec3& x : cloth.start_positions) x = Vec3(x.x(), x.z(), 0);
  return without_air(std::move(cloth), run.step);
}

SimulationInput cantilever(const MeshAndStep& run) {
  ClothInput cloth;
  cloth.mesh = clamped_strip(run);
  cloth.start_positions = cloth.mesh.positions;
  pin_where(cloth, [](const Vec3& x) { return x.x() < 1e-9; });
  cloth.material.elastic.density = cantilever_density;
  cloth.material.elastic.bend_stiffness = {cantilever_rigidity, cantilever_rigidity};
  return without_air(std::move(cloth), run.step);
}

SimulationInput sheet_on_a_ball(const MeshAndStep& run) {
  constexpr double radius = 0.4, crown = 0.066;
  ClothInput cloth = square_metre(run);
  pin_where(cloth, [](const Vec3& x) { return x.cwiseAbs().maxCoeff() < crown / 2; });
  for (Vec3& x : cloth.start_positions) x.y() += radius + 0.006;
  ClothMaterial& material = cloth.material;
  material.elastic.density = 0.5;
  material.elastic.bend_stiffness = {0.02, 0.01};
  material.elastic.shear_stiffness = 200;
  material.thickness = 0.005;
  material.friction = 0;
  SimulationInput input = without_air(std::move(cloth), run.step);
  input.colliders.push_back({"ball", SphereShape{radius}, {}, 0});
  return input;
}

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

std::vector<Vec3> sample_square(const Simulation& simulation, double side, const Vec3& middle, int samples) {
  const auto along = [&](int i) { return side * (i / (samples - 1.0) - 0.5); };
  std::vector<Vec3> places;
  for (int row = 0; row < samples; ++row)
    for (int column = 0; column < samples; ++column)
      places.push_back(place_of(simulation.input().cloths[0].mesh, simulation.state().positions,
                                middle + Vec3(along(column), 0, along(row))));
  return places;
}

double rms_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace drape::test
