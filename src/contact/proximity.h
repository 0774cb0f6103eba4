#pragma once

#include <vector>

#include "contact/patch_pair.h"
#include "core/incidence.h"

namespace drape {

// Where the vertices are at a step's start, and where they are about to go.
struct StepMotion {
  const std::vector<Vec3>& start;
  const std::vector<Vec3>& end;
};

// The broad phase: the pairs of patches that may meet, each with its own list of pairs of primitives. A list
// stays good until its two patches have moved relative to one another by more than its margin; then it alone
// is made anew. What is found with the lists does not depend on when they were made: they leave out only what
// can't touch.
struct Proximity {
  std::vector<Patch> patches;
  Incidence triangles_at;         // vertices: slot 3 t + k is corner k of the geometry's triangle t
  std::vector<PatchPair> pairs;   // of all patches whose rooms come within reach; by second patch, then first
  std::vector<Bounds> rooms;      // how far each patch may move before its partners are sought again
  std::vector<Bounds> moved;      // the box of how far its vertices have moved since
  std::vector<Vec4> vertex_ways;  // in this step
  std::vector<Bounds> ways;       // the box of the ways of each patch's vertices
};

// Margins of lists, in metres. A patch that moves fast gets more, so that its lists last for some steps.
struct ProximityMargins {
  double least = 0, most = 0;  // of a list
  double room = 0;             // the least that a patch's room gives it beyond where it is
};

Proximity start_proximity(const ContactGeometry& geometry);

// Makes the lists hold all pairs that can touch in this step, though each vertex may stop anywhere on its
// way. Returns how many lists were made anew.
int update_proximity(const ContactGeometry& geometry, const StepMotion& motion,
                     const ProximityMargins& margins, Proximity& proximity);

// Counts a finished step, which the next one is to go on from. `motion` may differ from what the lists were
// last updated for in where vertices have stopped on their ways.
void follow_motion(const StepMotion& motion, Proximity& proximity);

// A bound of how far points of two patches move relative to each other in this step.
double relative_way(const Proximity& proximity, const PatchPair& pair);
// The same where each vertex may stop anywhere on its way.
double relative_way_if_stopped(const Proximity& proximity, const PatchPair& pair);

}  // namespace drape
