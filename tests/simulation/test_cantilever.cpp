#include <gtest/gtest.h>

#include <cmath>

#include "simulation/elastica.h"
#include "simulation/shapes_at_rest.h"

namespace drape {
namespace {

using namespace test;

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

void expect_elastica(const MeshAndStep& run) {
  Simulation simulation(cantilever(run));
  settle(simulation, 1.5);
  const Tip tip = mean_tip(simulation),
            exact = elastica_tip(overhang, cantilever_rigidity, cantilever_density);
  EXPECT_LT(std::hypot(tip.x - exact.x, tip.y - exact.y), 0.01 * overhang)
      << run.points << (run.irregular ? " irregular " : " regular ") << run.step;
}

TEST(Cantilever, BendsAsTheElasticaOfItsRigidityWhateverTheMesh) {
  for (const int points : {16, 24})
    for (const bool irregular : {false, true}) expect_elastica({points, irregular, 0.002});
}

TEST(Cantilever, BendsAsTheElasticaOfItsRigidityWhateverTheStep) {
  for (const double step : {0.001, 0.005}) expect_elastica({16, false, step});
}

}  // namespace
}  // namespace drape
