#include "contact/response.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace drape {
namespace {

constexpr int most_sweeps = 30;

std::vector<Vec4> all_padded(const std::vector<Vec3>& x) {
  std::vector<Vec4> result(x.size());
  parallel_for_each(x.size(), 1024, [&](std::size_t v) { result[v] = padded(x[v]); });
  return result;
}

void unpad(const std::vector<Vec4>& padded, std::vector<Vec3>& x) {
  parallel_for_each(x.size(), 1024, [&](std::size_t v) { x[v] = padded[v].head<3>(); });
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
  constexpr double tolerance = 0.01;  // of the thickness
  Pull pull;
  pull.vertices = vertices_that_count(contact);
  pull.target = contact.target;
  pull.push_target = memory.paused_steps > 0 ? contact.paused_push_target : contact.push_target;
  pull.tolerance = tolerance * contact.thickness;
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

// What the sweeps may leave over of a contact whose sides went so far in the step, squared both: where things
// rest a remainder is a velocity of its own, and a heap of folds would never lie still.
double squared_tolerance(const Pull& pull, double squared_way) {
  constexpr double share = 0.25, at_rest = 0.05;  // of the way; of what may be left where things move
  const double most = pull.tolerance * pull.tolerance;
  return std::clamp(share * share * squared_way, at_rest * at_rest * most, most);
}

// One visit of one contact; returns how far it moved the sides, squared, in tolerances.
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
  return pull.mobility * pull.mobility * impulse.squaredNorm() /
         squared_tolerance(pull, (apart - pull.origin).squaredNorm());
}

// The sweep in which each vertex was moved last by what counts, 0 at first. A contact whose vertices stand
// since the sweep before has nothing new to solve.
using LastMoves = std::vector<unsigned char>;
static_assert(most_sweeps <= 255);

bool was_moved(const LastMoves& last_moves, const Pull& pull, int sweep) {
  const auto& v = pull.vertices;
  return std::max({last_moves[v[0]], last_moves[v[1]], last_moves[v[2]], last_moves[v[3]]}) >= sweep - 1;
}

void note_move(const Pull& pull, int sweep, LastMoves& last_moves) {
  for (int i = 0; i < 4; ++i)
    if (pull.responses[i] != 0) last_moves[pull.vertices[i]] = static_cast<unsigned char>(sweep);
}

// Returns whether it moved them.
bool push(Pull& pull, std::vector<Vec4>& x) {
  const double lack = pull.push_target - pull.normal.dot(weighted_sum(pull, x));
  if (!(pull.mobility > 0) || lack <= 0) return false;
  const double impulse = lack * pull.effective_mass;
  pull.push_impulse += impulse;
  apply_impulse(pull, (impulse * pull.normal).eval(), x);
  return true;
}

// Returns how far it moved the sides, in tolerances; appends the vertices that it moved.
double keep_firm(const Pull& pull, std::vector<Vec3>& x, std::vector<int>& moved) {
  const Vec3 normal = pull.normal.head<3>();
  const double target = pull.target + pull.push_impulse * pull.mobility;
  const double lack = target - normal.dot(weighted_sum(pull, x));
  if (!(pull.mobility > 0) || lack <= 0) return 0;
  apply_impulse(pull, (lack * pull.effective_mass * normal).eval(), x);
  for (int i = 0; i < 4; ++i)
    if (pull.responses[i] != 0) moved.push_back(pull.vertices[i]);
  return lack / pull.tolerance;
}

// A visit for each contact of a range in the sweep of this number. Returns whether one of them asks for
// another sweep.
template <typename Visit>
bool sweep_range(const Visit& visit, int sweep, std::size_t begin, std::size_t end, auto& pulls) {
  bool again = false;
  for (std::size_t i = begin; i < end; ++i) again |= visit(pulls[i], sweep);
  return again;
}

// Its parts at once, then what joins them.
template <typename Visit>
bool sweep_group(const Visit& visit, int sweep, const CollisionGroup& group, auto& pulls) {
  const std::vector<std::size_t>& begin = group.part_begin;
  std::vector<char> again(begin.size(), false);
  if (!begin.empty())
    parallel_for_each(begin.size() - 1, 1, [&](std::size_t p) {
      again[p] = sweep_range(visit, sweep, begin[p], begin[p + 1], pulls);
    });
  const bool joint_again = sweep_range(visit, sweep, group.joints_begin, group.end, pulls);
  return joint_again || std::find(again.begin(), again.end(), true) != again.end();
}

// Up to `most` sweeps over each group, the first is number 1, until none of its contacts asks for another.
template <typename Visit>
void sweep_groups(int most, const Visit& visit, auto& response) {
  parallel_for_each(response.groups.groups.size(), 1, [&](std::size_t g) {
    for (int sweep = 1; sweep <= most; ++sweep)
      if (!sweep_group(visit, sweep, response.groups.groups[g], response.pulls)) return;
  });
}

}  // namespace

Response begin_response(const ContactGeometry& geometry, const std::vector<Contact>& contacts,
                        const std::vector<ContactMemory>& memories, double farthest,
                        const std::vector<Vec3>& start) {
  const ContactMemory nothing{0, Vec3::Zero(), 0};
  Response response{group_contacts(geometry, start, contacts), std::vector<Pull>(contacts.size()), {}};
  parallel_collect(contacts.size(), 128, response.firm,
                   [&](std::size_t begin, std::size_t end, std::vector<std::size_t>& firm) {
                     for (std::size_t i = begin; i < end; ++i) {
                       const int c = response.groups.order[i];
                       const Contact& contact = contacts[c];
                       response.pulls[i] = make_pull(
                           geometry, contact, memories.empty() ? nothing : memories[c], farthest, start);
                       if (contact.is_firm) firm.push_back(i);
                     }
                   });
  return response;
}

void hold_again(const Response& response, std::vector<Vec3>& x) {
  const auto visit = [&](const Pull& pull, int) {
    if (pull.impulse > 0)
      apply_impulse(pull, Vec3(pull.impulse * pull.normal.head<3>() + pull.friction_impulse.head<3>()), x);
    return false;
  };
  sweep_groups(1, visit, response);
}

void resolve_contacts(Response& response, std::vector<Vec3>& x) {
  constexpr double counts = 0.01;  // of the tolerance: many little moves add up
  if (response.pulls.empty()) return;
  std::vector<Vec4> places = all_padded(x);
  LastMoves last_moves(x.size(), 0);
  const auto visit = [&](Pull& pull, int sweep) {
    if (!was_moved(last_moves, pull, sweep)) return false;
    const double moved = solve(pull, places);
    if (moved > counts * counts) note_move(pull, sweep, last_moves);
    return moved > 1;
  };
  sweep_groups(most_sweeps, visit, response);
  unpad(places, x);
}

void push_apart(Response& response, std::vector<Vec3>& x) {
  constexpr int most_pushes = 2;
  if (response.pulls.empty()) return;
  std::vector<Vec4> places = all_padded(x);
  sweep_groups(
      most_pushes, [&](Pull& pull, int) { return push(pull, places); }, response);
  unpad(places, x);
}

std::vector<int> keep_firm_contacts(const Response& response, std::vector<Vec3>& x) {
  constexpr double left = 0.1;  // of the tolerance: firm sides may lack no more
  std::vector<int> moved;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double farthest = 0;
    for (const std::size_t i : response.firm)
      farthest = std::max(farthest, keep_firm(response.pulls[i], x, moved));
    if (farthest <= left) break;
  }
  return moved;
}

std::vector<Vec3> take_pushes(std::int64_t pause, Response& response, const std::vector<Vec3>& end) {
  constexpr double in_vain = 0.9;  // of the push, that its sides have parted
  std::vector<Vec3> ways(end.size(), Vec3::Zero());
  const auto visit = [&](Pull& pull, int) {
    if (pull.push_impulse == 0) return false;
    const Vec3 way = weighted_sum(pull, end) - pull.origin.head<3>(), normal = pull.normal.head<3>();
    const double share = std::clamp(normal.dot(way) / (pull.push_impulse * pull.mobility), 0.0, 1.0);
    if (share < in_vain) pull.paused_steps = pause;
    apply_impulse(pull, Vec3(share * pull.push_impulse * normal), ways);
    return false;
  };
  sweep_groups(1, visit, response);
  return ways;
}

std::vector<ContactMemory> memories_of(const Response& response) {
  std::vector<ContactMemory> memories(response.pulls.size());
  parallel_for_each(memories.size(), 256, [&](std::size_t i) {
    const Pull& pull = response.pulls[i];
    memories[response.groups.order[i]] = {pull.impulse, pull.friction_impulse.head<3>(), pull.paused_steps};
  });
  return memories;
}

}  // namespace drape
