#pragma once

#include <vector>

#include "contact/active_contacts.h"

namespace drape {

struct FailSafeResult {
  std::vector<double> vertex_progress;  // the share of its way that each vertex went
  std::vector<double> body_progress;    // the share of its way that each body's colliders went; 1 for cloths
  int limited_vertices = 0;             // how many vertices were held back
  int passes = 0;
};

// The last word on a step: however badly the response failed, no pair of the lists comes nearer than
// phase.least_gap (or than it was, where that is less), so nothing passes through anything. Each vertex goes
// only a share of its way: "divide and truncate". A pair that would collide is locked: two parallel planes
// part its sides, each side keeps behind its own, and the room between is shared by speed of approach,
// colliders first. It ends since a pair locks once, is right since a vertex that is behind a plane at both
// ends of a straight way is behind it all along, and leaves untouched, to the bit, a step that needs none of
// it. Planes of the scene are sides of their own.
//
// The lists must be those of this motion. On return `end` is what the vertices reach. Rigid colliders go one
// share, the least of their vertices.
FailSafeResult hold_back(const NarrowPhase& phase, const Proximity& proximity, std::vector<Vec3>& end);

}  // namespace drape
