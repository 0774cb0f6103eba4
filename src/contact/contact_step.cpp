#include "contact/contact_step.h"

#include <algorithm>

#include "contact/fail_safe.h"
#include "contact/response.h"

namespace drape {
namespace {

double mean_cloth_edge(const ContactGeometry& geometry) {
  double sum = 0;
  int count = 0;
  for (const ContactBody& body : geometry.bodies)
    for (int e = body.edge_begin; body.is_cloth && e < body.edge_end; ++e, ++count) {
      const auto& [a, b] = geometry.edges[e];
      sum += (geometry.rest_positions[a] - geometry.rest_positions[b]).norm();
    }
  return count > 0 ? sum / count : 1;
}

void find_pairs(const ContactGeometry& geometry, const ContactSettings& settings, const StepMotion& motion,
                ContactCache& cache) {
  for (ProximityList& list : cache.lists)
    update_proximity(geometry, motion, settings.pad, settings.cell_size, list);
}

std::vector<Contact> find_contacts(const NarrowPhase& phase, ContactCache& cache) {
  std::vector<Contact> contacts;
  for (ProximityList& list : cache.lists) find_active_pairs(phase, list, contacts);
  // Which list a contact comes from, and when that was built, must not matter.
  std::sort(contacts.begin(), contacts.end(),
            [](const Contact& a, const Contact& b) { return a.key < b.key; });
  find_plane_contacts(phase, contacts);
  return contacts;
}

std::vector<ContactKey> sorted_keys(const std::vector<Contact>& contacts) {
  std::vector<ContactKey> keys;
  keys.reserve(contacts.size());
  for (const Contact& contact : contacts) keys.push_back(contact.key);
  std::sort(keys.begin(), keys.end());
  return keys;
}

// Contacts that the response itself has made: pairs that are active on the way to where it led, and pairs
// whose closest feature it has moved. Returns whether there are any.
bool add_new_contacts(const NarrowPhase& phase, ContactCache& cache, std::vector<Contact>& contacts) {
  const std::vector<ContactKey> known = sorted_keys(contacts);
  std::vector<Contact> added;
  find_moved_contacts(phase, contacts, added);
  for (const Contact& contact : find_contacts(phase, cache))
    if (!std::binary_search(known.begin(), known.end(), contact.key)) added.push_back(contact);
  contacts.insert(contacts.end(), added.begin(), added.end());
  return !added.empty();
}

// Finds and resolves in turn until the response makes no new contacts.
std::vector<Contact> resolve(const NarrowPhase& phase, const ContactSettings& settings, ContactCache& cache,
                             Profile& profile, std::vector<Vec3>& end) {
  constexpr int most_passes = 3;
  std::vector<Contact> contacts;
  for (int pass = 0; pass < most_passes; ++pass) {
    timed(profile, Phase::broad, [&] { find_pairs(phase.geometry, settings, phase.motion, cache); });
    const bool found =
        timed(profile, Phase::narrow, [&] { return add_new_contacts(phase, cache, contacts); });
    if (!found) break;
    timed(profile, Phase::response, [&] {
      resolve_contacts(phase.geometry, phase.motion.start, settings.largest_thickness, contacts, end);
    });
  }
  return contacts;
}

// Moves overlapping sides apart; returns what of the way was that.
std::vector<Vec3> push(const ContactGeometry& geometry, const std::vector<Contact>& contacts,
                       std::vector<Vec3>& end) {
  std::vector<Vec3> way = end;
  push_apart(geometry, contacts, end);
  for (std::size_t v = 0; v < end.size(); ++v) way[v] = end[v] - way[v];
  return way;
}

// The fail-safe, again where it has held vertices so far back from their paths that the lists may lack a
// pair.
FailSafeResult hold_back_all(const NarrowPhase& phase, const ContactSettings& settings, ContactCache& cache,
                             Profile& profile, std::vector<Vec3>& end) {
  FailSafeResult result;
  result.vertex_progress.assign(end.size(), 1.0);
  result.body_progress.assign(phase.geometry.bodies.size(), 1.0);
  do {
    timed(profile, Phase::broad, [&] { find_pairs(phase.geometry, settings, phase.motion, cache); });
    const FailSafeResult held = timed(profile, Phase::fail_safe,
                                      [&] { return hold_back(phase, cache.lists, settings.least_gap, end); });
    for (std::size_t v = 0; v < end.size(); ++v) result.vertex_progress[v] *= held.vertex_progress[v];
    for (std::size_t b = 0; b < result.body_progress.size(); ++b)
      result.body_progress[b] *= held.body_progress[b];
    result.limited_vertices += held.limited_vertices;
  } while (!std::all_of(cache.lists.begin(), cache.lists.end(), [&](const ProximityList& list) {
    return within_boxes(phase.geometry, list, phase.motion);
  }));
  return result;
}

}  // namespace

ContactSettings contact_settings(const ContactGeometry& geometry) {
  const double edge = mean_cloth_edge(geometry);
  ContactSettings settings;
  for (const ContactBody& body : geometry.bodies)
    settings.largest_thickness = std::max(settings.largest_thickness, body.thickness);
  settings.pad = 0.15 * edge;
  settings.cell_size = 2 * edge;
  return settings;
}

ContactCache empty_contact_cache(const ContactGeometry& geometry) {
  ContactCache cache;
  for (int b = 0; b < static_cast<int>(geometry.bodies.size()); ++b)
    if (geometry.bodies[b].is_cloth && geometry.self_collision) {
      cache.lists.emplace_back();
      cache.lists.back().own_body = b;
    }
  cache.lists.emplace_back();  // between bodies
  return cache;
}

ContactStepResult step_contacts(const ContactGeometry& geometry, const ContactSettings& settings,
                                const std::vector<BodyMotion>& bodies, const std::vector<Vec3>& start,
                                ContactCache& cache, Profile& profile, std::vector<Vec3>& end) {
  const NarrowPhase phase{geometry, bodies, {start, end}};
  ContactStepResult result;
  const std::vector<Contact> contacts = resolve(phase, settings, cache, profile, end);
  result.contacts = static_cast<int>(contacts.size());
  timed(profile, Phase::response, [&] { result.push = push(geometry, contacts, end); });
  const FailSafeResult held = hold_back_all(phase, settings, cache, profile, end);
  for (std::size_t v = 0; v < end.size(); ++v) result.push[v] *= held.vertex_progress[v];
  result.body_progress = held.body_progress;
  result.limited_vertices = held.limited_vertices;
  timed(profile, Phase::broad, [&] {
    for (ProximityList& list : cache.lists) follow_motion(geometry, phase.motion, list);
  });
  return result;
}

}  // namespace drape
