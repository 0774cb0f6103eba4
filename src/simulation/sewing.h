#pragma once

#include "contact/contact_geometry.h"
#include "deformation/seams.h"
#include "simulation/input.h"

namespace drape {

// The seams between the simulation's vertices, one thread for each pair. Their gap is the distance that
// contact keeps, so that the two agree; the thread does not see what bending keeps within a cloth.
SeamStage sew(const SimulationInput& input, const ContactGeometry& geometry);

}  // namespace drape
