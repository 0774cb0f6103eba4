#include "contact/response.h"

#include <algorithm>
#include <atomic>
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

// One visit of one contact; returns how far it moved the sides, squared, in tolerances. Most of a heap's time
// goes by here: calls of what it is made of would take a twelfth of that.
[[gnu::flatten]] double solve(Pull& pull, std::vector<Vec4>& x) {
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

// Returns how far it moved the sides, in tolerances; notes the vertices that it moved.
double keep_firm(const Pull& pull, std::vector<Vec3>& x, std::vector<char>& moved) {
  const Vec3 normal = pull.normal.head<3>();
  const double target = pull.target + pull.push_impulse * pull.mobility;
  const double lack = target - normal.dot(weighted_sum(pull, x));
  if (!(pull.mobility > 0) || lack <= 0) return 0;
  apply_impulse(pull, (lack * pull.effective_mass * normal).eval(), x);
  for (int i = 0; i < 4; ++i)
    if (pull.responses[i] != 0) moved[pull.vertices[i]] = 1;
  return lack / pull.tolerance;
}

// Calls visit_part(p) for the parts of a round, of which p has the items [begin[p] .. begin[p + 1]) to visit:
// at once, unless they are so few that threads would only wait for each other. The bits are the same.
template <typename VisitPart>
void visit_round(std::size_t first, std::size_t last, const std::vector<std::size_t>& begin,
                 const VisitPart& visit_part) {
  constexpr std::size_t few = 512;
  const std::size_t parts = last - first, parts_a_block = begin[last] - begin[first] < few ? parts : 1;
  parallel_for_each(parts, parts_a_block, [&](std::size_t i) { visit_part(first + i); });
}

// Up to `most` sweeps over each group, the first is number 1, until no item asks for another. Of part p the
// items are [begin[p] .. begin[p + 1]), and visit(item, sweep) returns whether it asks.
template <typename Visit>
void sweep_groups(int most, const CollisionGroups& groups, const std::vector<std::size_t>& begin,
                  const Visit& visit) {
  constexpr std::size_t groups_a_block = 16;  // most are small
  parallel_for_each(groups.group_count(), groups_a_block, [&](std::size_t g) {
    std::atomic<bool> again = true;
    const auto visit_part = [&](std::size_t part, int sweep) {
      bool asked = false;
      for (std::size_t i = begin[part]; i < begin[part + 1]; ++i) asked |= visit(i, sweep);
      if (asked) again.store(true, std::memory_order_relaxed);
    };
    for (int sweep = 1; sweep <= most && again; ++sweep) {
      again = false;
      for (std::size_t round = groups.group_begin[g]; round < groups.group_begin[g + 1]; ++round)
        visit_round(groups.round_begin[round], groups.round_begin[round + 1], begin,
                    [&](std::size_t part) { visit_part(part, sweep); });
    }
  });
}

// The same for all contacts: visit(pull, sweep).
template <typename Visit>
void sweep_contacts(int most, const Visit& visit, auto& response) {
  sweep_groups(most, response.groups, response.groups.part_begin,
               [&](std::size_t i, int sweep) { return visit(response.pulls[i], sweep); });
}

// `firm` is in order; see Response.
std::vector<std::size_t> begin_of_parts(const CollisionGroups& groups, const std::vector<std::size_t>& firm) {
  std::vector<std::size_t> begin(groups.part_begin.size());
  auto at = firm.begin();
  for (std::size_t p = 0; p < begin.size(); ++p) {
    while (at != firm.end() && *at < groups.part_begin[p]) ++at;
    begin[p] = static_cast<std::size_t>(at - firm.begin());
  }
  return begin;
}

}  // namespace

Response begin_response(const ContactGeometry& geometry, const std::vector<Contact>& contacts,
                        const std::vector<ContactMemory>& memories, double farthest,
                        const std::vector<Vec3>& start) {
  const ContactMemory nothing{0, Vec3::Zero(), 0};
  Response response{group_contacts(geometry, start, contacts), std::vector<Pull>(contacts.size()), {}, {}};
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
  response.firm_begin = begin_of_parts(response.groups, response.firm);
  return response;
}

void hold_again(const Response& response, std::vector<Vec3>& x) {
  const auto visit = [&](const Pull& pull, int) {
    if (pull.impulse > 0)
      apply_impulse(pull, Vec3(pull.impulse * pull.normal.head<3>() + pull.friction_impulse.head<3>()), x);
    return false;
  };
  sweep_contacts(1, visit, response);
}

void resolve_contacts(Response& response, std::vector<Vec3>& x) {
  constexpr double counts = 0.05;  // of the tolerance: little moves add up
  if (response.pulls.empty()) return;
  std::vector<Vec4> places = all_padded(x);
  LastMoves last_moves(x.size(), 0);
  const auto visit = [&](Pull& pull, int sweep) {
    if (!was_moved(last_moves, pull, sweep)) return false;
    const double moved = solve(pull, places);
    if (moved > counts * counts) note_move(pull, sweep, last_moves);
    return moved > 1;
  };
  sweep_contacts(most_sweeps, visit, response);
  unpad(places, x);
}

void push_apart(Response& response, std::vector<Vec3>& x) {
  constexpr int most_pushes = 2;
  if (response.pulls.empty()) return;
  std::vector<Vec4> places = all_padded(x);
  sweep_contacts(
      most_pushes, [&](Pull& pull, int) { return push(pull, places); }, response);
  unpad(places, x);
}

std::vector<char> keep_firm_contacts(const Response& response, std::vector<Vec3>& x) {
  constexpr double left = 0.1;  // of the tolerance: firm sides may lack no more
  std::vector<char> moved(x.size(), 0);
  sweep_groups(most_sweeps, response.groups, response.firm_begin, [&](std::size_t i, int) {
    return keep_firm(response.pulls[response.firm[i]], x, moved) > left;
  });
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
  sweep_contacts(1, visit, response);
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
