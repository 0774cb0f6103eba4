#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "contact/active_contacts.h"
#include "simulation/input.h"
#include "simulation/simulation.h"

namespace drape {

// One pin: which vertices it holds, when, and how they go on from where they were grabbed.
struct Pin {
  std::vector<int> vertices;   // of the simulation
  std::size_t first_grab = 0;  // where the state's grabs of its vertices start
  double from = 0;             // seconds
  std::optional<double> until;
  std::optional<RigidMotion> motion;
  std::optional<int> collider;
};

std::vector<Pin> build_pins(const std::vector<ClothInput>& cloths);

bool holds(const Pin& pin, double time);

// One flag for each of `count` vertices: whether a pin holds it at `time` (s).
std::vector<char> pinned_vertices(const std::vector<Pin>& pins, std::size_t count, double time);

// Records where the vertices of the pins that begin to hold at `time` are: in the world, or in the frame of
// the collider that they follow. To be called at the start of each frame.
void grab(const std::vector<Pin>& pins, double time, State& state);

// Moves what the pins hold during a step from `begin` to `end` (s) to where it is at its end: `colliders` are
// the ways of all colliders in that step. What contact has kept from getting there catches up at no more than
// half a metre a second over the pin's own pace.
void place_pinned(const std::vector<Pin>& pins, double begin, double end, const State& state,
                  std::span<const BodyMotion> colliders, std::vector<Vec3>& x);

// How far the pinned vertex is that is farthest from where its pin would have it at `time` (s), in m. To be
// called at the end of each frame: a pin that begins to hold then has grabbed nothing yet, and is left out.
double largest_pin_lag(const std::vector<Pin>& pins, double time, const State& state);

}  // namespace drape
