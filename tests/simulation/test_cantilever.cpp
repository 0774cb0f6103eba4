#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/primitives.h"
#include "simulation/scenarios.h"

namespace drape {
namespace {

using namespace test;

constexpr double overhang = 0.2, rigidity = 5e-4,
                 density = 0.2;  // m, N m, kg/m2: it hangs well past 45 degrees

struct Tip {
  double x, y;
};

// The elastica of a strip clamped level at 0 that bends under its weight: B th'' = -rho g (L - s) cos th,
// th(0) = 0, th'(L) = 0, with th the angle below the level. `curvature` at the clamp is what is shot with;
// returns th'(L).
double shoot(double curvature, Tip& tip) {
  constexpr int parts = 2000;
  constexpr double h = overhang / parts;
  double angle = 0;
  tip = {0, 0};
  for (int i = 0; i < parts; ++i) {
    const auto rate = [](double s, double th) {
      return -density * 9.81 * (overhang - s) * std::cos(th) / rigidity;
    };
    const double middle = angle + 0.5 * h * curvature;
    curvature += h * rate((i + 0.5) * h, middle);
    angle += h * (curvature - 0.5 * h * rate((i + 0.5) * h, middle));
    tip.x += h * std::cos(middle);
    tip.y -= h * std::sin(middle);
  }
  return curvature;
}

Tip exact_tip() {
  double low = 0, high = density * 9.81 * overhang * overhang / (2 * rigidity);
  Tip tip{};
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (shoot(middle, tip) > 0 ? high : low) = middle;
  }
  return tip;
}

// A square that is clamped along a strip of one cell beside the overhang.
SimulationInput cantilever(int points, bool irregular, double step) {
  const double edge = overhang / (points - 1);
  ClothInput cloth;
  cloth.mesh = make_grid({overhang + edge, overhang}, {points + 1, points});
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> share(-0.3, 0.3);
  cloth.pins.resize(1);
  for (std::size_t v = 0; v < cloth.mesh.positions.size(); ++v) {
    Vec3& x = cloth.mesh.positions[v];
    x.x() += (overhang - edge) / 2;
    if (x.x() < 1e-9) cloth.pins[0].vertices.push_back(static_cast<int>(v));
    const bool inside = x.x() > 1e-9 && x.x() < overhang - 1e-9 && std::abs(x.z()) < overhang / 2 - 1e-9;
    if (irregular && inside) x += edge * Vec3(share(engine), 0, share(engine));
  }
  cloth.start_positions = cloth.mesh.positions;
  cloth.material.elastic.density = density;
  cloth.material.elastic.bend_stiffness = {rigidity, rigidity};
  SimulationInput input = simulate_alone(cloth);
  input.self_collision = false;
  input.frame_duration = input.largest_step = step;
  remove_air(input);
  return input;
}

// Dynamic relaxation (Day 1965): all velocities go whenever the kinetic energy has passed a peak.
void settle(Simulation& simulation, double seconds) {
  double before = 0;
  for (double time = 0; time < seconds; time += simulation.input().frame_duration) {
    const double energy = simulation.advance_frame().kinetic_energy;
    const bool past_a_peak = energy < before;
    before = past_a_peak ? 0 : energy;
    if (!past_a_peak) continue;
    State state = simulation.state();
    for (Vec3& velocity : state.velocities) velocity.setZero();
    simulation.restore(std::move(state));
  }
}

Tip mean_tip(const Simulation& simulation) {
  const ClothInput& cloth = simulation.input().cloths[0];
  Tip tip{};
  int count = 0;
  for (std::size_t v = 0; v < cloth.mesh.positions.size(); ++v) {
    if (cloth.mesh.positions[v].x() < overhang - 1e-9) continue;
    tip.x += simulation.state().positions[v].x();
    tip.y += simulation.state().positions[v].y();
    ++count;
  }
  return {tip.x / count, tip.y / count};
}

void expect_elastica(int points, bool irregular, double step) {
  Simulation simulation(cantilever(points, irregular, step));
  settle(simulation, 1.5);
  const Tip tip = mean_tip(simulation), exact = exact_tip();
  EXPECT_LT(std::hypot(tip.x - exact.x, tip.y - exact.y), 0.01 * overhang)
      << points << (irregular ? " irregular " : " regular ") << step;
}

TEST(Cantilever, BendsAsTheElasticaOfItsRigidityWhateverTheMesh) {
  for (const int points : {16, 24})
    for (const bool irregular : {false, true}) expect_elastica(points, irregular, 0.002);
}

TEST(Cantilever, BendsAsTheElasticaOfItsRigidityWhateverTheStep) {
  for (const double step : {0.001, 0.005}) expect_elastica(16, false, step);
}

}  // namespace
}  // namespace drape
