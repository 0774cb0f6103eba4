#pragma once

#include <string>

#include "app/frame_certificate.h"
#include "app/run.h"
#include "simulation/simulation.h"

namespace drape::app {

// A simulation that cannot go on: the last good state, and the one that it led to.
struct FailedFrame {
  const State& before;
  const State& after;
  CertifiedSurface certified;  // of `after`
  std::string reason;
};

// Writes all that is needed to look into it as the folder `failure` of the run: the state before as a
// checkpoint, both shapes as OBJ files, the points and faces at fault in words and in a picture, and the
// command that makes that frame again, for which the run's own checkpoint must be the state before. Then
// throws SimulationError.
[[noreturn]] void stop_with_capsule(const Run& run, const FailedFrame& failed);

}  // namespace drape::app
