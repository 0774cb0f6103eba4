#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "deformation/bending_angle.h"
#include "deformation/mass_spring.h"

namespace drape {
namespace {

constexpr std::size_t block = 256;

void measure_spring(const MassSpringModel& model, std::size_t e, const std::vector<Vec3>& x,
                    MassSpringScratch& scratch) {
  const Spring& spring = model.springs[e];
  const Vec3 along = x[spring.vertices[1]] - x[spring.vertices[0]];
  const double length = along.norm();
  const Vec3 direction = length > 0 ? Vec3(along / length) : Vec3(Vec3::Zero());
  scratch.gradients[2 * e] = -direction;
  scratch.gradients[2 * e + 1] = direction;
  scratch.elastic[e] = spring.stiffness * (length - spring.rest_length);
}

// Where triangles are squeezed to slivers the gradients, 1 / height, grow without bound, and so would the
// stiffness k_e |g|2 that the step must be small for. From twice the rest shape's |g|2 on, the element is
// weakened to keep that.
double weakening(const BendingElement& element, const BendingAngle& angle) {
  double rest = 0, now = 0;
  for (int i = 0; i < 4; ++i) {
    rest += element.gradient_lengths[i] * element.gradient_lengths[i];
    now += angle.gradients[i].squaredNorm();
  }
  return now > 2 * rest ? std::sqrt(2 * rest / now) : 1;
}

// BMF03, section 4, F_i = k_e |E|2 / (|N1| + |N2|) (sin(theta / 2) - rest) u_i, with |E| and |N| of the rest
// shape, for which it is the gradient of an energy.
void measure_bending(const MassSpringModel& model, std::size_t e, const std::vector<Vec3>& x,
                     MassSpringScratch& scratch) {
  const BendingElement& element = model.bending[e];
  const BendingAngle angle = bending_angle(element.vertices, x);
  const double share = weakening(element, angle);
  const std::size_t slot = 2 * model.springs.size() + 4 * e;
  for (int i = 0; i < 4; ++i) scratch.gradients[slot + i] = share * angle.gradients[i];
  scratch.elastic[model.springs.size() + e] =
      share * element.stiffness * (angle.half_sine - element.rest_sine);
}

void measure_elements(const MassSpringModel& model, const std::vector<Vec3>& x, MassSpringScratch& scratch) {
  const std::size_t springs = model.springs.size(), bending = model.bending.size();
  scratch.gradients.resize(2 * springs + 4 * bending);
  scratch.elastic.resize(springs + bending);
  parallel_for_each(springs, block, [&](std::size_t e) { measure_spring(model, e, x, scratch); });
  parallel_for_each(bending, block, [&](std::size_t e) { measure_bending(model, e, x, scratch); });
}

template <typename Element>
double damped_force(const Element& element, const Vec3* gradients, double elastic,
                    const std::vector<Vec3>& v) {
  double rate = 0;
  for (std::size_t i = 0; i < element.vertices.size(); ++i) rate += gradients[i].dot(v[element.vertices[i]]);
  return elastic + element.damping * rate;
}

void find_forces(const MassSpringModel& model, const std::vector<Vec3>& v, MassSpringScratch& scratch) {
  const std::size_t springs = model.springs.size();
  scratch.force.resize(scratch.elastic.size());
  parallel_for_each(springs, block, [&](std::size_t e) {
    scratch.force[e] = damped_force(model.springs[e], &scratch.gradients[2 * e], scratch.elastic[e], v);
  });
  parallel_for_each(model.bending.size(), block, [&](std::size_t e) {
    scratch.force[springs + e] = damped_force(model.bending[e], &scratch.gradients[2 * springs + 4 * e],
                                              scratch.elastic[springs + e], v);
  });
}

Vec3 force_on(const MassSpringModel& model, const MassSpringScratch& scratch, std::size_t vertex) {
  const std::size_t springs = model.springs.size();
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = model.incidence.begin[vertex]; i < model.incidence.begin[vertex + 1]; ++i) {
    const std::size_t slot = model.incidence.slots[i];
    const std::size_t element = slot < 2 * springs ? slot / 2 : springs + (slot - 2 * springs) / 4;
    sum -= scratch.force[element] * scratch.gradients[slot];
  }
  return sum;
}

void drift(const MassSpringModel& model, double time, const std::vector<Vec3>& v, std::vector<Vec3>& x) {
  parallel_for_each(x.size(), block, [&](std::size_t i) {
    if (model.inverse_masses[i] > 0) x[i] += time * v[i];
  });
}

// kicked = v + time * a, with the forces found last.
void kick(const MassSpringModel& model, const std::vector<Vec3>& accelerations, double time,
          const MassSpringScratch& scratch, const std::vector<Vec3>& v, std::vector<Vec3>& kicked) {
  kicked.resize(v.size());
  parallel_for_each(v.size(), block, [&](std::size_t i) {
    const double w = model.inverse_masses[i];
    kicked[i] = w > 0 ? Vec3(v[i] + time * (accelerations[i] + w * force_on(model, scratch, i))) : v[i];
  });
}

void check_step(const MassSpringModel& model, double step) {
  if (step <= model.stable_step) return;
  throw SimulationError(fmt::format(
      "the mass-spring model is explicit and stable for steps of at most {:.4g} s; a step of {:.4g} s "
      "would make it explode: take {} times as many steps, or a softer or heavier material",
      model.stable_step, step, static_cast<int>(std::ceil(step / model.stable_step))));
}

// Stiffness and damping of an element that bounds K and C as K_e g g^T, and the lengths of its gradients.
struct ElementBound {
  double stiffness, damping;
  std::array<double, 4> lengths;
};

ElementBound bound_of(const Spring& spring) { return {spring.stiffness, spring.damping, {1, 1, 0, 0}}; }

// Flat, the stiffness is half of k_e |E|2 / (|N1| + |N2|), as sin(theta / 2) ~ theta / 2; folded, the turning
// of u_i adds to it.
ElementBound bound_of(const BendingElement& element) {
  return {element.stiffness, element.damping, element.gradient_lengths};
}

// Adds to each point its row of M^-1 K and M^-1 C by the norms of their blocks.
template <typename Element>
void add_rows(const std::vector<Element>& elements, const std::vector<double>& inverse_masses,
              std::vector<double>& stiffness_rows, std::vector<double>& damping_rows) {
  for (const Element& element : elements) {
    const ElementBound bound = bound_of(element);
    double sum = 0;
    for (const double length : bound.lengths) sum += length;
    for (std::size_t i = 0; i < element.vertices.size(); ++i) {
      const double row = inverse_masses[element.vertices[i]] * bound.lengths[i] * sum;
      stiffness_rows[element.vertices[i]] += bound.stiffness * row;
      damping_rows[element.vertices[i]] += bound.damping * row;
    }
  }
}

}  // namespace

// Gershgorin: no eigenvalue of M^-1 K (omega2) or M^-1 C (c) is larger than the largest sum of a row. The
// leapfrog is stable for h <= 2 / omega (sqrt(1 + xi2) - xi), xi = c / (2 omega) (Belytschko, Liu and Moran,
// Nonlinear Finite Elements, 6.2, where damping lags by half a step), written here so that omega may be 0. A
// spring under tension is as stiff across as its strain is along, so the blocks' norms hold in every
// direction.
double largest_stable_step(const MassSpringModel& model) {
  const std::size_t count = model.inverse_masses.size();
  std::vector<double> stiffness_rows(count, 0), damping_rows(count, 0);
  add_rows(model.springs, model.inverse_masses, stiffness_rows, damping_rows);
  add_rows(model.bending, model.inverse_masses, stiffness_rows, damping_rows);
  const auto largest = [](const std::vector<double>& rows) {
    return rows.empty() ? 0 : *std::max_element(rows.begin(), rows.end());
  };
  const double half_damping = largest(damping_rows) / 2;
  return 2 / (std::sqrt(largest(stiffness_rows) + half_damping * half_damping) + half_damping);
}

void advance_mass_spring(const MassSpringModel& model, const std::vector<Vec3>& accelerations, double step,
                         MassSpringScratch& scratch, std::vector<Vec3>& positions,
                         std::vector<Vec3>& velocities) {
  check_step(model, step);
  drift(model, step / 2, velocities, positions);
  measure_elements(model, positions, scratch);
  find_forces(model, velocities, scratch);
  kick(model, accelerations, step / 2, scratch, velocities, scratch.middle_velocities);
  find_forces(model, scratch.middle_velocities, scratch);
  kick(model, accelerations, step, scratch, velocities, velocities);
  drift(model, step / 2, velocities, positions);
}

}  // namespace drape
