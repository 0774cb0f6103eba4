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

void find_pairs(const NarrowPhase& phase, const ContactSettings& settings, Proximity& proximity) {
  update_proximity(phase.geometry, phase.motion, settings.margins, proximity);
}

std::vector<Contact> find_contacts(const NarrowPhase& phase, Proximity& proximity) {
  std::vector<Contact> contacts;
  find_active_pairs(phase, proximity, contacts);
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
bool add_new_contacts(const NarrowPhase& phase, Proximity& proximity, std::vector<Contact>& contacts) {
  const std::vector<ContactKey> known = sorted_keys(contacts);
  std::vector<Contact> added;
  find_moved_contacts(phase, contacts, added);
  for (const Contact& contact : find_contacts(phase, proximity))
    if (!std::binary_search(known.begin(), known.end(), contact.key)) added.push_back(contact);
  contacts.insert(contacts.end(), added.begin(), added.end());
  return !added.empty();
}

// Finds and resolves in turn until the response makes no new contacts.
std::vector<Contact> resolve(const NarrowPhase& phase, const ContactSettings& settings, Proximity& proximity,
                             Profile& profile, std::vector<Vec3>& end) {
  constexpr int most_passes = 3;
  std::vector<Contact> contacts;
  for (int pass = 0; pass < most_passes; ++pass) {
    timed(profile, Phase::broad, [&] { find_pairs(phase, settings, proximity); });
    const bool found =
        timed(profile, Phase::narrow, [&] { return add_new_contacts(phase, proximity, contacts); });
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

}  // namespace

static FailSafeResult let_go(const ContactGeometry& geometry) {
  return {std::vector<double>(geometry.vertex_body.size(), 1),
          std::vector<double>(geometry.bodies.size(), 1)};
}

ContactSettings contact_settings(const ContactGeometry& geometry, double step) {
  constexpr double healing_time = 0.04;  // s: a fold that is pushed open faster strains its edges
  const double edge = mean_cloth_edge(geometry);
  ContactSettings settings;
  for (const ContactBody& body : geometry.bodies)
    settings.largest_thickness = std::max(settings.largest_thickness, body.thickness);
  settings.healing = step / healing_time;
  settings.margins = {0.2 * edge, 0.5 * edge, 0.5 * edge};
  return settings;
}

ContactStepResult step_contacts(const ContactGeometry& geometry, const ContactSettings& settings,
                                const std::vector<BodyMotion>& bodies, const std::vector<Vec3>& start,
                                Proximity& proximity, Profile& profile, std::vector<Vec3>& end) {
  const NarrowPhase phase{geometry, bodies, {start, end}, settings.healing};
  ContactStepResult result;
  const std::vector<Contact> contacts = resolve(phase, settings, proximity, profile, end);
  result.contacts = static_cast<int>(contacts.size());
  timed(profile, Phase::response, [&] { result.push = push(geometry, contacts, end); });
  timed(profile, Phase::broad, [&] { find_pairs(phase, settings, proximity); });
  const FailSafeResult held = timed(profile, Phase::fail_safe, [&] {
    return settings.fail_safe ? hold_back(phase, proximity, settings.least_gap, end) : let_go(geometry);
  });
  for (std::size_t v = 0; v < end.size(); ++v) result.push[v] *= held.vertex_progress[v];
  result.body_progress = held.body_progress;
  result.limited_vertices = held.limited_vertices;
  timed(profile, Phase::broad, [&] { follow_motion(phase.motion, proximity); });
  return result;
}

}  // namespace drape
