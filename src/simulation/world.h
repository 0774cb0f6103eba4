#pragma once

#include <vector>

#include "contact/contact_geometry.h"
#include "contact/contact_step.h"
#include "deformation/momentum.h"
#include "deformation/seams.h"
#include "deformation/sheet.h"
#include "simulation/free_motion.h"
#include "simulation/input.h"
#include "simulation/pins.h"
#include "simulation/simulation.h"
#include "simulation/step_choice.h"

namespace drape {

// What is fixed once built (the part that depends on the pins is rebuilt when one lets go).
struct World {
  SimulationInput input;
  int steps_per_frame = 1;
  double step = 0;  // seconds
  // Air changes slowly, and costs as much as a sweep of clusters: its forces are felt anew only so often.
  int steps_per_air = 1;
  double still_way = 0;  // m: see rest.h

  Sheet sheet;                          // all cloths as one mesh
  std::vector<double> masses;           // kg, of each point
  std::vector<double> triangle_masses;  // kg
  std::vector<double> pressures;        // Pa along each triangle's normal; empty where no cloth has any
  std::vector<Pin> pins;
  SeamStage seams;
  std::vector<std::vector<Vec3>> collider_points;  // of each collider, in its own frame
  ContactGeometry geometry;
  ContactSettings contact_settings;

  std::vector<char> pinned;
  ModelParts model;
  std::vector<FreePiece> free_pieces;
};

// Of the world that would be built of `input`.
StepChoice choose_steps(const SimulationInput& input);

World build_world(SimulationInput input);
State initial_state(const World& world);

// Brings all that depends on which pins hold up to `time`; does nothing where none has changed.
void update_pins(World& world, double time);

}  // namespace drape
