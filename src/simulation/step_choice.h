#pragma once

#include "deformation/sheet.h"
#include "simulation/input.h"

namespace drape {

// The steps that a frame is cut into: equal ones, in every frame as many, each no longer than the input, the
// model, the thinnest cloth's contact and the fastest collider allow. Throws SimulationError as
// longest_model_step does.
struct StepChoice {
  int per_frame;
  double longest_for_model;  // seconds: the model's stable or accurate step
};

// `sheet` holds all cloths of `input`, `masses` the kg of each of its points.
StepChoice choose_steps(const SimulationInput& input, const Sheet& sheet, const std::vector<double>& masses);

}  // namespace drape
