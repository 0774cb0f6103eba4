#pragma once

#include <vector>

#include "deformation/bending.h"
#include "deformation/fibres.h"
#include "deformation/membrane.h"
#include "deformation/sheet.h"
#include "deformation/tethers.h"

namespace drape {

// The default deformation model, built for one step length and one set of pinned points.
struct ElasticModel {
  BendingStage bending;
  MembraneStage membrane;
  FibreStage fibres;
  TetherStage tethers;
  std::vector<Point4> inverse_masses;  // w: 1/kg, 0 where pinned; x, y, z are 0. Fillers follow the vertices
  double step = 0;                     // seconds
};

// The longest step that the materials of a sheet want, in seconds. What one sweep leaves undone grows with
// the square of the step, counted in what a wave does in it: of stretch, sqrt(k / rho) h / l edges crossed
// (fibres carry far, so a few do no harm where stretch is too small to be seen, but where its waves are
// slower than 360 m/s, fewer); of bending at the scale of the mesh, the phase sqrt(B / rho) h / l2.
double longest_elastic_step(const Sheet& sheet);

// Pinned points weigh 1e4 times their mass where rotations are matched, so that triangles turn about them.
ElasticModel build_elastic_model(const Sheet& sheet, const std::vector<double>& masses,
                                 const std::vector<char>& pinned, double gravity, double step);

// What a step works in. Positions are offsets in float from where the step starts: seven digits of how far a
// point moves in a step, not of where it is.
struct ElasticScratch {
  SplitPoints start;
  std::vector<Point4> offsets, velocities, accelerations;
  std::vector<LaneRow> bending_base, membrane_base;
  FibreScratch fibres;
  std::vector<Point4> tether_base;
};

// The motion of all points over one step without contact. `positions` and `velocities` come with their values
// at the step's start, those of pinned points with where they end; they leave with their values at its end.
void advance_elastic(const ElasticModel& model, const std::vector<Vec3>& accelerations,
                     const std::vector<Vec3>& start, ElasticScratch& scratch, std::vector<Vec3>& positions,
                     std::vector<Vec3>& velocities);

// The verbs of a step, for benchmarks and for the scalar twin in the tests.
void load_elastic(const ElasticModel& model, const std::vector<Vec3>& start, ElasticScratch& scratch);
void predict_offsets(const ElasticModel& model, ElasticScratch& scratch);
// x* -> x**: the weak and wide stages first, so that the stiff ones have the last word. Of these the fibres
// go before the own triangles: the other way round, a hanging sheet stretches several times as much.
void pull_to_goals(const ElasticModel& model, ElasticScratch& scratch);
void update_velocities(const ElasticModel& model, ElasticScratch& scratch);

}  // namespace drape
