#pragma once

#include "contact/proximity.h"

namespace drape {

// A triangle's edges and corners are its neighbours' too, and a point that is closest to one of them would
// make a contact with each. They would all hold the same, at a multiple of the cost, and those with a
// neighbour to which the point is not nearest would hold it back from sliding: their normals lean against its
// way. Tells whether the pair, closest as given when the step is done to the share `time`, leaves its contact
// to one of those that share what is closest, and keeps as much thickness: to one that is plainly nearer
// then, or to the first. Those that are about as near count as well, or rounding would decide in each step
// which of them holds the point; so does one that bends up like the other side of a valley, through which the
// point might go within the step. What meets on the way (`time` > 0) leaves its contact only to one that was
// there from the start: which of them comes first is not known so exactly.
//
// Pairs of edges and what is rounded (the closest point of a triangle to a ball's centre is one of many at
// which they touch) leave it to none.
bool is_left_to_neighbour(const ContactGeometry& geometry, const Incidence& triangles_at,
                          const StepMotion& motion, const ContactPair& pair, const ClosestPoints& closest,
                          double time);

}  // namespace drape
