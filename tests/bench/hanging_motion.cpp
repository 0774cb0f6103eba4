#include "hanging_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "deformation/elastic_model.h"
#include "deformation/mass_spring.h"

namespace drape::bench {
namespace {

constexpr double duration = 3, gravity = 9.81;

Motion at_rest(const HangingSheet& hanging) {
  const std::vector<Vec3>& positions = hanging.sheet.rest_positions;
  return {positions, std::vector<Vec3>(positions.size(), Vec3::Zero())};
}

// Irregular, and the same in every run.
void disturb(const HangingSheet& hanging, Motion& motion) {
  for (std::size_t i = 0; i < motion.velocities.size(); ++i)
    if (!hanging.pinned[i]) motion.velocities[i].z() = 0.1 * std::sin(static_cast<double>(i * i % 1009));
}

double energy(const HangingSheet& hanging, const Motion& motion) {
  double sum = 0;
  for (std::size_t i = 0; i < motion.positions.size(); ++i)
    sum += hanging.masses[i] * (0.5 * motion.velocities[i].squaredNorm() + gravity * motion.positions[i].y());
  return sum;
}

}  // namespace

Stepper shape_matching_stepper(const HangingSheet& hanging, double step) {
  struct Parts {
    ElasticModel model;
    ElasticScratch scratch;
    std::vector<Vec3> start;
  };
  const auto parts = std::make_shared<Parts>();
  parts->model = build_elastic_model(hanging.sheet, hanging.masses, hanging.pinned, gravity, step);
  return {step, [parts, &hanging](Motion& motion) {
            parts->start = motion.positions;
            advance_elastic(parts->model, hanging.gravity, parts->start, parts->scratch, motion.positions,
                            motion.velocities);
          }};
}

Stepper mass_spring_stepper(const HangingSheet& hanging, double step) {
  struct Parts {
    MassSpringModel model;
    MassSpringScratch scratch;
  };
  const auto parts = std::make_shared<Parts>();
  parts->model = build_mass_spring(hanging.sheet, hanging.masses, hanging.pinned);
  parts->model.stable_step = std::numeric_limits<double>::infinity();
  return {step, [parts, &hanging, step](Motion& motion) {
            advance_mass_spring(parts->model, hanging.gravity, step, parts->scratch, motion.positions,
                                motion.velocities);
          }};
}

Motion settle(const HangingSheet& hanging, const Stepper& stepper) {
  constexpr double drag = 6;  // 1/s
  Motion motion = at_rest(hanging);
  const double kept = std::exp(-drag * stepper.step);
  for (double time = 0; time < duration; time += stepper.step) {
    stepper.advance(motion);
    for (Vec3& velocity : motion.velocities) velocity *= kept;
  }
  return motion;
}

bool stays_bounded(const HangingSheet& hanging, const Stepper& stepper) {
  constexpr int most_steps = 6000;
  Motion motion = at_rest(hanging);
  disturb(hanging, motion);
  double weight = 0;
  for (const double mass : hanging.masses) weight += gravity * mass;
  const double most = energy(hanging, motion) + 0.01 * weight * hanging.side;
  const int steps = std::min(most_steps, static_cast<int>(duration / stepper.step));
  for (int i = 0; i < steps; ++i) {
    stepper.advance(motion);
    if (!(energy(hanging, motion) <= most)) return false;
  }
  return true;
}

Stretch stretch_of(const HangingSheet& hanging, const std::vector<Vec3>& positions) {
  std::vector<double> stretches;
  for (const Edge& edge : hanging.sheet.topology.edges) {
    const auto& [a, b] = edge.vertices;
    stretches.push_back((positions[a] - positions[b]).norm() / rest_length(hanging.sheet, edge));
  }
  std::sort(stretches.begin(), stretches.end());
  return {stretches[static_cast<std::size_t>(0.99 * static_cast<double>(stretches.size() - 1))],
          stretches.back()};
}

double largest_speed(const Motion& motion) {
  double largest = 0;
  for (const Vec3& velocity : motion.velocities) largest = std::max(largest, velocity.norm());
  return largest;
}

}  // namespace drape::bench
