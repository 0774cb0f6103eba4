#include "contact/response.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/parallel.h"

namespace drape {
namespace {

int root_of(std::vector<int>& parents, int v) {
  while (parents[v] != v) v = parents[v] = parents[parents[v]];
  return v;
}

// Union-find over the moving vertices; the root is the smallest vertex of the group.
void join_vertices(const ContactGeometry& geometry, const Contact& contact, std::vector<int>& parents) {
  int first = -1;
  for (int i = 0; i < 4; ++i) {
    if (contact.weights[i] == 0 || geometry.inverse_masses[contact.vertices[i]] == 0) continue;
    const int root = root_of(parents, contact.vertices[i]);
    if (first < 0) first = root;
    const auto [low, high] = std::minmax(first, root);
    parents[high] = low;
    first = low;
  }
}

int group_root(const ContactGeometry& geometry, const Contact& contact, std::vector<int>& parents) {
  for (int i = 0; i < 4; ++i)
    if (contact.weights[i] != 0 && geometry.inverse_masses[contact.vertices[i]] > 0)
      return root_of(parents, contact.vertices[i]);
  return -1;
}

// What the sweeps need of a contact, in the order in which they come to it.
struct Pull {
  std::array<int, 4> vertices;
  std::array<double, 4> weights, responses;  // the second: how far each vertex goes under a unit impulse
  Vec3 normal;
  double mobility;  // how far the sides part under a unit impulse
  double target, friction;
  Vec3 origin;  // where the sides were to each other at the start, less what turns with a collider
  double impulse = 0;
  Vec3 friction_impulse = Vec3::Zero();
};

Vec3 weighted_sum(const Pull& pull, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 4; ++i)
    if (pull.weights[i] != 0) sum += pull.weights[i] * x[pull.vertices[i]];  // may be another group's
  return sum;
}

Pull make_pull(const ContactGeometry& geometry, const Contact& contact, double target,
               const std::vector<Vec3>& start) {
  Pull pull{contact.vertices, contact.weights,  {},           contact.normal, 0,
            target,           contact.friction, -contact.turn};
  for (int i = 0; i < 4; ++i) {
    pull.responses[i] = geometry.inverse_masses[contact.vertices[i]] * contact.weights[i];
    pull.mobility += pull.responses[i] * contact.weights[i];
  }
  pull.origin += weighted_sum(pull, start);
  return pull;
}

void apply_impulse(const Pull& pull, const Vec3& impulse, std::vector<Vec3>& x) {
  for (int i = 0; i < 4; ++i)
    if (pull.responses[i] != 0)  // a collider may be another group's too
      x[pull.vertices[i]] += pull.responses[i] * impulse;
}

// The impulse that Coulomb's cone allows for, after one that would stop all sliding since the step's start.
Vec3 friction_impulse(const Pull& pull, const Vec3& way) {
  const Vec3 sliding = way - pull.normal.dot(way) * pull.normal;
  const Vec3 sticking = pull.friction_impulse - sliding / pull.mobility;
  const double most = pull.friction * pull.impulse, length = sticking.norm();
  return length > most ? Vec3(sticking * (most / length)) : sticking;
}

// One visit of one contact; returns how far it moved the sides, in metres.
double solve(Pull& pull, std::vector<Vec3>& x) {
  if (!(pull.mobility > 0)) return 0;
  const Vec3 apart = weighted_sum(pull, x);
  const double violation = pull.normal.dot(apart) - pull.target;
  if (violation >= 0 && pull.impulse == 0 && pull.friction_impulse.isZero(0)) return 0;
  const double change = std::max(-violation / pull.mobility, -pull.impulse);
  pull.impulse += change;
  Vec3 impulse = change * pull.normal;
  if (pull.friction > 0 && (pull.impulse > 0 || !pull.friction_impulse.isZero(0))) {
    const Vec3 friction = friction_impulse(pull, apart + pull.mobility * impulse - pull.origin);
    impulse += friction - pull.friction_impulse;
    pull.friction_impulse = friction;
  }
  apply_impulse(pull, impulse, x);
  return pull.mobility * impulse.norm();
}

double push(Pull& pull, std::vector<Vec3>& x) {
  const double lack = pull.target - pull.normal.dot(weighted_sum(pull, x));
  if (!(pull.mobility > 0) || lack <= 0) return 0;
  pull.impulse += lack / pull.mobility;
  apply_impulse(pull, lack / pull.mobility * pull.normal, x);
  return lack;
}

// Of all contacts, in the order of their groups. `target` says which of a contact's.
std::vector<Pull> make_pulls(const ContactGeometry& geometry, const CollisionGroups& groups,
                             const std::vector<Contact>& contacts, double Contact::*target,
                             const std::vector<Vec3>& start) {
  std::vector<Pull> pulls(contacts.size());
  parallel_for_each(pulls.size(), 512, [&](std::size_t i) {
    const Contact& contact = contacts[groups.order[i]];
    pulls[i] = make_pull(geometry, contact, contact.*target, start);
  });
  return pulls;
}

// Up to `sweeps` sweeps over each group, groups in parallel, until a sweep moves nothing by more than
// `enough`.
template <typename Visit>
void sweep_groups(const CollisionGroups& groups, int sweeps, double enough, const Visit& visit) {
  parallel_for_each(groups.group_begin.size() - 1, 1, [&](std::size_t g) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      double largest = 0;
      for (std::size_t i = groups.group_begin[g]; i < groups.group_begin[g + 1]; ++i)
        largest = std::max(largest, visit(i));
      if (largest <= enough) return;
    }
  });
}

}  // namespace

CollisionGroups group_contacts(const ContactGeometry& geometry, const std::vector<Contact>& contacts) {
  std::vector<int> parents(geometry.vertex_body.size());
  std::iota(parents.begin(), parents.end(), 0);
  for (const Contact& contact : contacts) join_vertices(geometry, contact, parents);
  std::vector<int> roots(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) roots[i] = group_root(geometry, contacts[i], parents);

  CollisionGroups groups{std::vector<int>(contacts.size()), {0}};
  std::iota(groups.order.begin(), groups.order.end(), 0);
  std::stable_sort(groups.order.begin(), groups.order.end(),
                   [&](int a, int b) { return roots[a] < roots[b]; });
  for (std::size_t i = 1; i <= contacts.size(); ++i)
    if (i == contacts.size() || roots[groups.order[i]] != roots[groups.order[i - 1]])
      groups.group_begin.push_back(i);
  return groups;
}

void resolve_contacts(const ContactGeometry& geometry, const CollisionGroups& groups,
                      const std::vector<Vec3>& start, double thickness, std::vector<Contact>& contacts,
                      std::vector<Vec3>& x) {
  constexpr int most_sweeps = 30;
  constexpr double settled = 0.01;
  std::vector<Pull> pulls = make_pulls(geometry, groups, contacts, &Contact::target, start);
  sweep_groups(groups, most_sweeps, settled * thickness, [&](std::size_t i) { return solve(pulls[i], x); });
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    contacts[groups.order[i]].impulse = pulls[i].impulse;
    contacts[groups.order[i]].friction_impulse = pulls[i].friction_impulse;
  }
}

std::vector<double> push_apart(const ContactGeometry& geometry, const CollisionGroups& groups,
                               const std::vector<Contact>& contacts, std::vector<Vec3>& x) {
  constexpr int most_sweeps = 2;
  std::vector<Pull> pulls = make_pulls(geometry, groups, contacts, &Contact::push_target, x);
  sweep_groups(groups, most_sweeps, 0, [&](std::size_t i) { return push(pulls[i], x); });
  std::vector<double> impulses(contacts.size());
  for (std::size_t i = 0; i < pulls.size(); ++i) impulses[groups.order[i]] = pulls[i].impulse;
  return impulses;
}

std::vector<Vec3> pushed_ways(const ContactGeometry& geometry, const std::vector<Contact>& contacts,
                              const std::vector<double>& push_impulses, const std::vector<Vec3>& start,
                              const std::vector<Vec3>& end) {
  std::vector<Vec3> ways(end.size(), Vec3::Zero());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (push_impulses[i] == 0) continue;
    const Pull pull = make_pull(geometry, contacts[i], 0, start);
    const double parted = pull.normal.dot(weighted_sum(pull, end) - pull.origin);
    const double share = std::clamp(parted / (push_impulses[i] * pull.mobility), 0.0, 1.0);
    apply_impulse(pull, share * push_impulses[i] * pull.normal, ways);
  }
  return ways;
}

}  // namespace drape
