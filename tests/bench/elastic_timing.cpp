#include "elastic_timing.h"

#include <algorithm>

#include "machine.h"

namespace drape::bench {
namespace {

constexpr double step = 0.002;  // s, as in the paper's Fig. 1

// Runs work() and keeps the least CPU time that it took.
template <typename Work>
void time_least(double& least, const Work& work) {
  const double start = thread_seconds();
  work();
  least = std::min(least, thread_seconds() - start);
}

std::size_t bytes(const SweepOrder& order) {
  return bytes_of(order.elements, order.tile_begin, order.patch_begin, order.color_begin);
}

std::size_t bytes(const Incidence& incidence) { return bytes_of(incidence.begin, incidence.slots); }

}  // namespace

void ElasticRun::run(double seconds) {
  constexpr int fewest_steps = 2;
  const double end = wall_seconds() + seconds;
  for (int steps = 0; steps < fewest_steps || wall_seconds() < end; ++steps) {
    const double start = wall_seconds();
    time_least(least_.cpu, [&] { advance(); });
    least_.wall = std::min(least_.wall, wall_seconds() - start);
    time_stages(least_);
  }
}

ShapeMatchingRun::ShapeMatchingRun(const HangingSheet& hanging)
    : ElasticRun(hanging),
      model_(build_elastic_model(hanging.sheet, hanging.masses, hanging.pinned, 9.81, step)) {}

void ShapeMatchingRun::advance() {
  start_ = x_;
  advance_elastic(model_, hanging_.gravity, start_, scratch_, x_, v_);
}

// The next step, verb by verb, with the velocities that advance() left in the scratch; its end is thrown
// away.
void ShapeMatchingRun::time_stages(Least& least) {
  auto& times = least.stages;
  std::vector<Point4>& offsets = scratch_.offsets;
  time_least(times[loading], [&] { load_elastic(model_, x_, scratch_); });
  time_least(times[damping], [&] {
    damp_bending(model_.bending, scratch_.velocities);
    damp_membrane(model_.membrane, scratch_.membrane_base, scratch_.velocities);
  });
  time_least(times[prediction], [&] { predict_offsets(model_, scratch_); });
  time_least(times[bending], [&] { pull_bending(model_.bending, scratch_.bending_base, offsets); });
  time_least(times[tethers], [&] { pull_tethers(model_.tethers, scratch_.tether_base, offsets); });
  time_least(times[fibres], [&] { pull_fibres(model_.fibres, scratch_.fibres, offsets); });
  time_least(times[membrane], [&] { pull_membrane(model_.membrane, scratch_.membrane_base, offsets); });
  time_least(times[velocities], [&] { update_velocities(model_, scratch_); });
}

std::size_t ShapeMatchingRun::model_bytes() const {
  const auto& [bending, membrane, fibres, tethers, inverse_masses, step_length] = model_;
  return sizeof step_length + bytes(bending.order) +
         bytes_of(bending.corners, bending.coordinates, bending.steps) +
         bytes_of(bending.dampings, bending.rest) + bytes(membrane.order) +
         bytes_of(membrane.corners, membrane.shapes, membrane.stresses, membrane.dampings) +
         bytes_of(fibres.vertices, fibres.row_begin, fibres.rest_lengths, fibres.compliances) +
         bytes_of(fibres.longest, fibres.color_begin, tethers.tethers, inverse_masses);
}

std::size_t ShapeMatchingRun::scratch_bytes() const {
  return bytes_of(scratch_.start.high, scratch_.start.low, scratch_.offsets, scratch_.velocities) +
         bytes_of(scratch_.accelerations, scratch_.bending_base, scratch_.membrane_base) +
         bytes_of(scratch_.fibres.base, scratch_.fibres.work, scratch_.tether_base);
}

MassSpringRun::MassSpringRun(const HangingSheet& hanging)
    : ElasticRun(hanging), model_(build_mass_spring(hanging.sheet, hanging.masses, hanging.pinned)) {}

void MassSpringRun::advance() {
  advance_mass_spring(model_, hanging_.gravity, std::min(step, model_.stable_step), scratch_, x_, v_);
}

std::size_t MassSpringRun::model_bytes() const {
  return bytes_of(model_.springs, model_.bending, model_.inverse_masses) + bytes(model_.incidence);
}

std::size_t MassSpringRun::scratch_bytes() const {
  return bytes_of(scratch_.gradients, scratch_.elastic, scratch_.force, scratch_.middle_velocities);
}

AveragedRun::AveragedRun(const HangingSheet& hanging)
    : ElasticRun(hanging), model_(build_averaged_model(hanging.sheet, hanging.masses, hanging.pinned, 1)) {}

// MHTG05: x* = x + h (v + h a), and the velocity from x**.
void AveragedRun::advance() {
  start_ = x_;
  for (std::size_t i = 0; i < x_.size(); ++i)
    if (!hanging_.pinned[i]) x_[i] += step * (v_[i] + step * hanging_.gravity[i]);
  pull_averaged(model_, scratch_, x_);
  for (std::size_t i = 0; i < x_.size(); ++i) v_[i] = (x_[i] - start_[i]) / step;
}

std::size_t AveragedRun::model_bytes() const {
  return bytes_of(model_.vertices, model_.rest, model_.fibre_begin, model_.rest_lengths, model_.weights) +
         bytes_of(model_.pinned) + bytes(model_.incidence);
}

std::size_t AveragedRun::scratch_bytes() const { return bytes_of(scratch_.displacements); }

}  // namespace drape::bench
