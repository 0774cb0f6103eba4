#pragma once

#include <vector>

#include "simulation/simulation.h"

// Sheets whose shape at rest is one and the same for every mesh and step that is fine enough: set-ups to
// compare meshes and steps with.
namespace drape::test {

struct MeshAndStep {
  int points;      // along each side
  bool irregular;  // those inside moved by up to three tenths of an edge
  double step;     // s, of a frame
};

// A square metre of the default cloth that hangs from two corners.
SimulationInput hanging_sheet(const MeshAndStep& run);

// A square of `overhang` m, clamped level along one side by a further row of cells.
constexpr double overhang = 0.2, cantilever_rigidity = 5e-4,
                 cantilever_density = 0.2;  // m, N m, kg/m2: it hangs well past 45 degrees
SimulationInput cantilever(const MeshAndStep& run);

// A square metre of stiff cloth over a ball. The crown is held and nothing rubs, so that the shape is the one
// of least energy, not what the fall left; and weft bends more easily than warp, which says the way it folds.
SimulationInput sheet_on_a_ball(const MeshAndStep& run);

// Dynamic relaxation (Day 1965): all velocities go whenever the kinetic energy has passed a peak.
void settle(Simulation& simulation, double seconds);

// Where `samples` x `samples` points are of the square of `side` m whose middle is `middle` in the first
// cloth's rest shape, which lies in a plane of equal y.
std::vector<Vec3> sample_square(const Simulation& simulation, double side, const Vec3& middle, int samples);

// Root mean square of the distances between two samples of as many points.
double rms_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

}  // namespace drape::test
