#include "contact/response.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace drape {
namespace {

std::vector<Vec4> all_padded(const std::vector<Vec3>& x) {
  std::vector<Vec4> result(x.size());
  parallel_for_each(x.size(), 4096, [&](std::size_t v) { result[v] = padded(x[v]); });
  return result;
}

void unpad(const std::vector<Vec4>& padded, std::vector<Vec3>& x) {
  parallel_for_each(x.size(), 4096, [&](std::size_t v) { x[v] = padded[v].head<3>(); });
}

template <typename Points>
auto weighted_sum(const Pull& pull, const Points& x) {
  return (pull.weights[0] * x[pull.vertices[0]] + pull.weights[1] * x[pull.vertices[1]] +
          pull.weights[2] * x[pull.vertices[2]] + pull.weights[3] * x[pull.vertices[3]])
      .eval();
}

// A vertex that plays no part may be another group's, whose thread writes it: one that plays a part is read
// in its place.
std::array<int, 4> vertices_that_count(const Contact& contact) {
  const int first = contact.weights[0] != 0 ? 0 : contact.weights[1] != 0 ? 1 : 2;
  std::array<int, 4> vertices = contact.vertices;
  for (int i = 0; i < 4; ++i)
    if (contact.weights[i] == 0) vertices[i] = vertices[first];
  return vertices;
}

// What held it before, as far as that parts the sides by no more than `farthest`, and nothing where these
// cannot move any more; of its friction what goes across the normal now.
void start_with(const ContactMemory& memory, double farthest, Pull& pull) {
  const double way = memory.impulse * pull.mobility;
  const double share = way > farthest ? farthest / way : way > 0 ? 1 : 0;
  const Vec4 friction = share * padded(memory.friction_impulse);
  pull.impulse = share * memory.impulse;
  pull.friction_impulse = friction - pull.normal.dot(friction) * pull.normal;
  pull.paused_steps = std::max<std::int64_t>(memory.paused_steps - 1, 0);
}

Pull make_pull(const ContactGeometry& geometry, const Contact& contact, const ContactMemory& memory,
               double farthest, const std::vector<Vec3>& start) {
  Pull pull;
  pull.vertices = vertices_that_count(contact);
  pull.target = contact.target;
  pull.push_target = memory.paused_steps > 0 ? contact.paused_push_target : contact.push_target;
  pull.friction = contact.friction;
  pull.normal = padded(contact.normal);
  pull.push_impulse = pull.mobility = 0;
  for (int i = 0; i < 4; ++i) {
    pull.weights[i] = contact.weights[i];
    pull.responses[i] = geometry.inverse_masses[contact.vertices[i]] * contact.weights[i];
    pull.mobility += pull.responses[i] * contact.weights[i];
  }
  pull.effective_mass = pull.mobility > 0 ? 1 / pull.mobility : 0;
  pull.origin = padded(weighted_sum(pull, start) - contact.turn);
  start_with(memory, farthest, pull);
  return pull;
}

template <typename Points, typename Impulse>
void apply_impulse(const Pull& pull, const Impulse& impulse, Points& x) {
  for (int i = 0; i < 4; ++i)
    if (pull.responses[i] != 0)  // a collider may be another group's too
      x[pull.vertices[i]] += pull.responses[i] * impulse;
}

// The impulse that Coulomb's cone allows for, after one that would stop all sliding since the step's start.
Vec4 friction_impulse(const Pull& pull, const Vec4& way) {
  const Vec4 sliding = way - pull.normal.dot(way) * pull.normal;
  const Vec4 sticking = pull.friction_impulse - pull.effective_mass * sliding;
  const double most = pull.friction * pull.impulse, squared_length = sticking.squaredNorm();
  return squared_length > most * most ? Vec4(sticking * (most / std::sqrt(squared_length))) : sticking;
}

// Returns 0: what it moves is not for a sweep to settle.
double hold_again(const Pull& pull, std::vector<Vec4>& x) {
  if (pull.impulse > 0) apply_impulse(pull, (pull.impulse * pull.normal + pull.friction_impulse).eval(), x);
  return 0;
}

// One visit of one contact; returns how far it moved the sides, in metres, squared.
double solve(Pull& pull, std::vector<Vec4>& x) {
  if (!(pull.mobility > 0)) return 0;
  const Vec4 apart = weighted_sum(pull, x);
  const double violation = pull.normal.dot(apart) - pull.target;
  if (violation >= 0 && pull.impulse == 0 && pull.friction_impulse.isZero(0)) return 0;
  const double change = std::max(-violation * pull.effective_mass, -pull.impulse);
  pull.impulse += change;
  Vec4 impulse = change * pull.normal;
  if (pull.friction > 0 && (pull.impulse > 0 || !pull.friction_impulse.isZero(0))) {
    const Vec4 friction = friction_impulse(pull, apart + pull.mobility * impulse - pull.origin);
    impulse += friction - pull.friction_impulse;
    pull.friction_impulse = friction;
  }
  apply_impulse(pull, impulse, x);
  return pull.mobility * pull.mobility * impulse.squaredNorm();
}

double push(Pull& pull, std::vector<Vec4>& x) {
  const double lack = pull.push_target - pull.normal.dot(weighted_sum(pull, x));
  if (!(pull.mobility > 0) || lack <= 0) return 0;
  const double impulse = lack * pull.effective_mass;
  pull.push_impulse += impulse;
  apply_impulse(pull, (impulse * pull.normal).eval(), x);
  return lack * lack;
}

// Returns how far it moved the sides; appends the vertices that it moved.
double keep_off(const Pull& pull, std::vector<Vec3>& x, std::vector<int>& moved) {
  const Vec3 normal = pull.normal.head<3>();
  const double target = pull.target + pull.push_impulse * pull.mobility;
  const double lack = target - normal.dot(weighted_sum(pull, x));
  if (!(pull.mobility > 0) || lack <= 0) return 0;
  apply_impulse(pull, (lack * pull.effective_mass * normal).eval(), x);
  for (int i = 0; i < 4; ++i)
    if (pull.responses[i] != 0) moved.push_back(pull.vertices[i]);
  return lack;
}

// A visit for each contact, up to `most` times, until none moves anything by more than `enough` metres. It
// returns how far it moved something, squared.
template <typename Visit>
struct Sweeps {
  int most;
  double enough;
  Visit visit;
};

// Returns whether anything moved by more than is enough.
template <typename Visit>
bool sweep_range(const Sweeps<Visit>& sweeps, std::size_t begin, std::size_t end, std::vector<Pull>& pulls) {
  bool moved = false;
  for (std::size_t i = begin; i < end; ++i) moved |= sweeps.visit(pulls[i]) > sweeps.enough * sweeps.enough;
  return moved;
}

// Its parts at once, then what joins them.
template <typename Visit>
bool sweep_group(const Sweeps<Visit>& sweeps, const CollisionGroup& group, std::vector<Pull>& pulls) {
  const std::vector<std::size_t>& begin = group.part_begin;
  std::vector<char> moved(begin.size(), false);
  if (!begin.empty())
    parallel_for_each(begin.size() - 1, 1,
                      [&](std::size_t p) { moved[p] = sweep_range(sweeps, begin[p], begin[p + 1], pulls); });
  const bool joint_moved = sweep_range(sweeps, group.joints_begin, group.end, pulls);
  return joint_moved || std::find(moved.begin(), moved.end(), true) != moved.end();
}

template <typename Visit>
void sweep_groups(int most, double enough, const Visit& visit, Response& response) {
  const Sweeps<Visit> sweeps{most, enough, visit};
  parallel_for_each(response.groups.groups.size(), 1, [&](std::size_t g) {
    for (int sweep = 0; sweep < sweeps.most; ++sweep)
      if (!sweep_group(sweeps, response.groups.groups[g], response.pulls)) return;
  });
}

constexpr int most_sweeps = 30;
constexpr double settled = 0.01;  // of the thickness

}  // namespace

Response begin_response(const ContactGeometry& geometry, const std::vector<Contact>& contacts,
                        const std::vector<ContactMemory>& memories, double farthest,
                        const std::vector<Vec3>& start) {
  const ContactMemory nothing{0, Vec3::Zero(), 0};
  Response response{group_contacts(geometry, start, contacts), std::vector<Pull>(contacts.size()), {}};
  parallel_collect(contacts.size(), 512, response.at_colliders,
                   [&](std::size_t begin, std::size_t end, std::vector<std::size_t>& at_colliders) {
                     for (std::size_t i = begin; i < end; ++i) {
                       const int c = response.groups.order[i];
                       const Contact& contact = contacts[c];
                       response.pulls[i] = make_pull(
                           geometry, contact, memories.empty() ? nothing : memories[c], farthest, start);
                       if (contact.meets_collider) at_colliders.push_back(i);
                     }
                   });
  return response;
}

void resolve_contacts(double thickness, Response& response, std::vector<Vec3>& x) {
  if (response.pulls.empty()) return;
  std::vector<Vec4> places = all_padded(x);
  sweep_groups(
      1, 0, [&](Pull& pull) { return hold_again(pull, places); }, response);
  sweep_groups(
      most_sweeps, settled * thickness, [&](Pull& pull) { return solve(pull, places); }, response);
  unpad(places, x);
}

void push_apart(Response& response, std::vector<Vec3>& x) {
  constexpr int most_pushes = 2;
  if (response.pulls.empty()) return;
  std::vector<Vec4> places = all_padded(x);
  sweep_groups(
      most_pushes, 0, [&](Pull& pull) { return push(pull, places); }, response);
  unpad(places, x);
}

std::vector<int> keep_off_colliders(double thickness, const Response& response, std::vector<Vec3>& x) {
  std::vector<int> moved;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double farthest = 0;
    for (const std::size_t i : response.at_colliders)
      farthest = std::max(farthest, keep_off(response.pulls[i], x, moved));
    if (farthest <= settled * thickness) break;
  }
  return moved;
}

std::vector<Vec3> take_pushes(std::int64_t pause, Response& response, const std::vector<Vec3>& end) {
  constexpr double in_vain = 0.9;  // of the push, that its sides have parted
  std::vector<Vec3> ways(end.size(), Vec3::Zero());
  const auto visit = [&](Pull& pull) {
    if (pull.push_impulse == 0) return 0.0;
    const Vec3 way = weighted_sum(pull, end) - pull.origin.head<3>(), normal = pull.normal.head<3>();
    const double share = std::clamp(normal.dot(way) / (pull.push_impulse * pull.mobility), 0.0, 1.0);
    if (share < in_vain) pull.paused_steps = pause;
    apply_impulse(pull, Vec3(share * pull.push_impulse * normal), ways);
    return 0.0;
  };
  sweep_groups(1, 0, visit, response);
  return ways;
}

std::vector<ContactMemory> memories_of(const Response& response) {
  std::vector<ContactMemory> memories(response.pulls.size());
  parallel_for_each(memories.size(), 512, [&](std::size_t i) {
    const Pull& pull = response.pulls[i];
    memories[response.groups.order[i]] = {pull.impulse, pull.friction_impulse.head<3>(), pull.paused_steps};
  });
  return memories;
}

}  // namespace drape
