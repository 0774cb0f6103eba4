#include "simulation/free_motion.h"

#include <fmt/format.h>

#include <limits>

#include "core/error.h"

namespace drape {

ModelParts build_model(const SimulationInput& input, const Sheet& sheet, const std::vector<double>& masses,
                       const std::vector<char>& pinned, double step) {
  switch (input.model) {
    case DeformationModel::averaged:
      return build_averaged_model(sheet, masses, pinned, input.alpha);
    case DeformationModel::mass_spring:
      return build_mass_spring(sheet, masses, pinned);
    case DeformationModel::shape_matching:
      break;
  }
  return build_elastic_model(sheet, masses, pinned, input.gravity.norm(), step);
}

// Points that a pin holds later only lower a spring's frequency: without pins the bound is the least.
static double stable_mass_spring_step(const Sheet& sheet, const std::vector<double>& masses) {
  constexpr double least_step = 1e-6;
  const std::vector<char> unpinned(masses.size(), 0);
  const double stable = build_mass_spring(sheet, masses, unpinned).stable_step;
  if (stable < least_step)
    throw SimulationError(
        fmt::format("mass_spring is stable only in steps of up to {:.3g} us with these materials and "
                    "edges, and would take too long: make the stretch or bend stiffness less, the "
                    "edges longer, or use the model shape_matching",
                    1e6 * stable));
  return stable;
}

double longest_model_step(const SimulationInput& input, const Sheet& sheet,
                          const std::vector<double>& masses) {
  switch (input.model) {
    case DeformationModel::averaged:
      return std::numeric_limits<double>::infinity();  // its stiffness is a share a step
    case DeformationModel::mass_spring:
      return stable_mass_spring_step(sheet, masses);
    case DeformationModel::shape_matching:
      break;
  }
  return longest_elastic_step(sheet);
}

namespace {

struct MoveFreely {
  const std::vector<Vec3>& accelerations;
  double step;
  const std::vector<char>& pinned;
  const std::vector<Vec3>& start;
  FreeMotionScratch& scratch;
  std::vector<Vec3>&positions, &velocities;

  void operator()(const ElasticModel& model) const {
    advance_elastic(model, accelerations, start, scratch.elastic, positions, velocities);
  }

  // MHTG05: v += h a, x* = x + h v, and the velocity from x** in the end.
  void operator()(const AveragedModel& model) const {
    for (std::size_t v = 0; v < start.size(); ++v)
      if (!pinned[v]) positions[v] = start[v] + step * (velocities[v] + step * accelerations[v]);
    pull_averaged(model, scratch.averaged, positions);
    for (std::size_t v = 0; v < start.size(); ++v) velocities[v] = (positions[v] - start[v]) / step;
  }

  // Pinned points are half way at the middle of the step, where the forces are those of the second order.
  void operator()(const MassSpringModel& model) const {
    std::vector<Vec3> ends = positions;
    for (std::size_t v = 0; v < start.size(); ++v) {
      if (!pinned[v]) continue;
      positions[v] = 0.5 * (start[v] + ends[v]);
      velocities[v] = (ends[v] - start[v]) / step;
    }
    advance_mass_spring(model, accelerations, step, scratch.mass_spring, positions, velocities);
    for (std::size_t v = 0; v < start.size(); ++v)
      if (pinned[v]) positions[v] = ends[v];
  }
};

}  // namespace

void move_freely(const ModelParts& model, const std::vector<Vec3>& accelerations, double step,
                 const std::vector<char>& pinned, const std::vector<Vec3>& start, FreeMotionScratch& scratch,
                 std::vector<Vec3>& positions, std::vector<Vec3>& velocities) {
  std::visit(MoveFreely{accelerations, step, pinned, start, scratch, positions, velocities}, model);
}

}  // namespace drape
