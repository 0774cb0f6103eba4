#pragma once

#include <functional>
#include <vector>

#include "hanging_sheet.h"

namespace drape::bench {

struct Motion {
  std::vector<Vec3> positions, velocities;
};

// One step of a model, of a length of its own.
struct Stepper {
  double step;  // s
  std::function<void(Motion&)> advance;
};

Stepper shape_matching_stepper(const HangingSheet& hanging, double step);

// With the model's own bound on steps set aside.
Stepper mass_spring_stepper(const HangingSheet& hanging, double step);

// The flat sheet, let go, with a drag on all velocities of 6/s for 3 s: critical for its swinging.
Motion settle(const HangingSheet& hanging, const Stepper& stepper);

// Whether kinetic energy and that of height, together, stay below their sum at the start (elastic energy is
// none there, and never negative), within a hundredth of weight times height: of the flat sheet, let go with
// small velocities out of its plane and no drag, for 3 s or 6000 steps, whichever ends first.
bool stays_bounded(const HangingSheet& hanging, const Stepper& stepper);

// Edge lengths over those at rest.
struct Stretch {
  double p99, largest;
};
Stretch stretch_of(const HangingSheet& hanging, const std::vector<Vec3>& positions);

double largest_speed(const Motion& motion);

}  // namespace drape::bench
