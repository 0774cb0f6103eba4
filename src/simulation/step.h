#pragma once

#include <vector>

#include "contact/contact_step.h"
#include "simulation/free_motion.h"
#include "simulation/simulation.h"
#include "simulation/world.h"

namespace drape {

// What one step needs to work in. What contact keeps in it from step to step changes no result.
struct Scratch {
  std::vector<Vec3> start, end;  // of all contact vertices: cloths, then colliders
  std::vector<Vec3> air_forces;  // of each triangle, kept for steps_per_air steps
  std::vector<Vec3> accelerations;
  std::vector<Vec3> free_velocities;  // of the cloths' points, where there is no contact
  std::vector<Vec3> free_positions;   // x**
  std::vector<Vec3> unsewn_positions;
  std::vector<BodyMotion> bodies;
  std::vector<double> collider_aims;  // seconds: the time on its way that each collider makes for
  FreeMotionScratch free_motion;
  ContactScratch contact;
};

// One step of the paper's loop (section 3), from time - step to `time`.
ContactStepResult advance_step(const World& world, double time, State& state, Scratch& scratch,
                               Profile& profile);

}  // namespace drape
