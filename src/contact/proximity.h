#pragma once

#include <vector>

#include "contact/contact_geometry.h"
#include "contact/spatial_hash.h"

namespace drape {

// The pairs that may come close while every vertex stays in its box: the result of the broad phase, which
// stays good for several steps. One list holds the pairs within one cloth, seen from a frame that moves along
// with it (a falling cloth does not leave its boxes); one holds the pairs between different bodies, in the
// world.
struct ProximityList {
  int own_body = -1;  // the cloth whose own pairs these are; -1: the pairs between bodies
  std::vector<ContactPair> pairs;

  bool built = false;
  std::vector<Vec3> lower, upper;   // the box that each vertex may move in, in the list's frame
  Vec3 frame_shift = Vec3::Zero();  // how far the frame has moved since the list was built
  std::vector<double> travelled;    // m: each vertex's way in the list's frame since the list was built
};

// Where the vertices are at a step's start, and where they are about to go.
struct StepMotion {
  const std::vector<Vec3>& start;
  const std::vector<Vec3>& end;
};

// How far the list's frame moves in this step.
Vec3 frame_motion(const ContactGeometry& geometry, const ProximityList& list, const StepMotion& motion);

// Rebuilds the list where a vertex is out of its box at the step's end; else keeps it. `pad` in
// metres: the room that a box gives beyond the step's motion. Returns whether it was rebuilt.
bool update_proximity(const ContactGeometry& geometry, const StepMotion& motion, double pad, double cell_size,
                      ProximityList& list);

// Whether the end of each vertex's way is still in its box.
bool within_boxes(const ContactGeometry& geometry, const ProximityList& list, const StepMotion& motion);

// Adds a finished step to the vertices' ways and to the frame's.
void follow_motion(const ContactGeometry& geometry, const StepMotion& motion, ProximityList& list);

}  // namespace drape
