#include "simulation/step_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/free_motion.h"

namespace drape {
namespace {

// A layer that falls from rest on another one sinks by no more than a tenth of its thickness in a step.
double longest_contact_step(const SimulationInput& input) {
  double thinnest = std::numeric_limits<double>::infinity();
  for (const ClothInput& cloth : input.cloths) thinnest = std::min(thinnest, cloth.material.thickness);
  return std::sqrt(2 * 0.1 * thinnest / std::max(input.gravity.norm(), 1e-9));
}

double mean_edge_length(const Sheet& sheet) {
  double sum = 0;
  for (const Edge& edge : sheet.topology.edges) sum += rest_length(sheet, edge);
  return sum / static_cast<double>(sheet.topology.edges.size());
}

// A collider goes by no more than a quarter of an edge: cloth that it hits is to follow it as a whole, not by
// the few edges that it has passed in a step.
double longest_collider_step(const SimulationInput& input, const Sheet& sheet) {
  double fastest = 0;
  for (const ColliderInput& collider : input.colliders)
    fastest = std::max(fastest, largest_speed(collider.motion));
  return fastest > 0 ? 0.25 * mean_edge_length(sheet) / fastest : std::numeric_limits<double>::infinity();
}

bool has_keys(const SimulationInput& input) {
  return std::any_of(input.colliders.begin(), input.colliders.end(),
                     [](const ColliderInput& collider) { return !is_static(collider.motion); });
}

}  // namespace

StepChoice choose_steps(const SimulationInput& input, const Sheet& sheet, const std::vector<double>& masses) {
  // A collider that was held up passes no key within a step: with fewer, it could not catch up where every
  // frame has a key.
  constexpr int least_with_keys = 4;
  const double model = longest_model_step(input, sheet, masses);
  const double longest =
      std::min({input.largest_step, model, longest_contact_step(input), longest_collider_step(input, sheet)});
  const int wanted = static_cast<int>(std::ceil(input.frame_duration / longest - 1e-9));
  return {has_keys(input) ? std::max(wanted, least_with_keys) : wanted, model};
}

}  // namespace drape
