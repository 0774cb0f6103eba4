#include "contact/response.h"

#include <algorithm>
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

Vec3 weighted_sum(const Contact& contact, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 4; ++i)
    if (contact.weights[i] != 0)
      sum += contact.weights[i] * x[contact.vertices[i]];  // may be another group's
  return sum;
}

// K: how far the sides part under a unit impulse.
double mobility(const ContactGeometry& geometry, const Contact& contact) {
  double sum = 0;
  for (int i = 0; i < 4; ++i)
    sum += geometry.inverse_masses[contact.vertices[i]] * contact.weights[i] * contact.weights[i];
  return sum;
}

void apply_impulse(const ContactGeometry& geometry, const Contact& contact, const Vec3& impulse,
                   std::vector<Vec3>& x) {
  for (int i = 0; i < 4; ++i) {
    const double response = geometry.inverse_masses[contact.vertices[i]] * contact.weights[i];
    if (response != 0) x[contact.vertices[i]] += response * impulse;  // a collider may be another group's too
  }
}

// The impulse that Coulomb's cone allows for, after one that would stop all sliding since the step's start.
Vec3 friction_impulse(const Contact& contact, double mobility, const std::vector<Vec3>& start,
                      const std::vector<Vec3>& x) {
  const Vec3 way = weighted_sum(contact, x) - weighted_sum(contact, start) + contact.turn;
  const Vec3 sliding = way - contact.normal.dot(way) * contact.normal;
  const Vec3 sticking = contact.friction_impulse - sliding / mobility;
  const double most = contact.friction * contact.impulse, length = sticking.norm();
  return length > most ? Vec3(sticking * (most / length)) : sticking;
}

// One visit of one contact; returns how far it moved the sides, in metres.
double solve_contact(const ContactGeometry& geometry, const std::vector<Vec3>& start, Contact& contact,
                     std::vector<Vec3>& x) {
  const double k = mobility(geometry, contact);
  if (!(k > 0)) return 0;
  const double violation = contact.normal.dot(weighted_sum(contact, x)) - contact.target;
  const double change = std::max(-violation / k, -contact.impulse);
  contact.impulse += change;
  Vec3 impulse = change * contact.normal;
  if (change != 0) apply_impulse(geometry, contact, impulse, x);
  if (contact.friction > 0 && (contact.impulse > 0 || !contact.friction_impulse.isZero(0))) {
    const Vec3 friction = friction_impulse(contact, k, start, x);
    apply_impulse(geometry, contact, friction - contact.friction_impulse, x);
    impulse += friction - contact.friction_impulse;
    contact.friction_impulse = friction;
  }
  return k * impulse.norm();
}

double push_contact(const ContactGeometry& geometry, const Contact& contact, std::vector<Vec3>& x) {
  const double k = mobility(geometry, contact);
  const double lack = contact.push_target - contact.normal.dot(weighted_sum(contact, x));
  if (!(k > 0) || lack <= 0) return 0;
  apply_impulse(geometry, contact, lack / k * contact.normal, x);
  return lack;
}

// Up to `sweeps` sweeps over each group, groups in parallel, until a sweep moves nothing by more than
// `enough`.
template <typename Visit>
void sweep_groups(const CollisionGroups& groups, int sweeps, double enough, const Visit& visit) {
  parallel_for_each(groups.group_begin.size() - 1, 1, [&](std::size_t g) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      double largest = 0;
      for (std::size_t i = groups.group_begin[g]; i < groups.group_begin[g + 1]; ++i)
        largest = std::max(largest, visit(groups.order[i]));
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

void resolve_contacts(const ContactGeometry& geometry, const std::vector<Vec3>& start, double thickness,
                      std::vector<Contact>& contacts, std::vector<Vec3>& x) {
  constexpr int most_sweeps = 30;
  constexpr double settled = 0.01;
  const CollisionGroups groups = group_contacts(geometry, contacts);
  sweep_groups(groups, most_sweeps, settled * thickness,
               [&](int i) { return solve_contact(geometry, start, contacts[i], x); });
}

void push_apart(const ContactGeometry& geometry, const std::vector<Contact>& contacts, std::vector<Vec3>& x) {
  constexpr int most_sweeps = 4;
  const CollisionGroups groups = group_contacts(geometry, contacts);
  sweep_groups(groups, most_sweeps, 0, [&](int i) { return push_contact(geometry, contacts[i], x); });
}

}  // namespace drape
