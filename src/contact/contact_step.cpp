#include "contact/contact_step.h"

#include <algorithm>
#include <utility>

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

// Pulls edges within their limits. Colliders have the last word: these go on, whatever cloth would like.
static void keep_to_limits(const NarrowPhase& phase, const ContactSettings& settings,
                           const Response& response, std::vector<Vec3>& end) {
  pull_within_limits(settings.edge_limits, phase.geometry.inverse_masses, end);
  keep_off_colliders(settings.largest_thickness, response, end);
}

static Response respond(const NarrowPhase& phase, const ContactSettings& settings,
                        const std::vector<Contact>& contacts, std::vector<Vec3>& end) {
  Response response = begin_response(phase.geometry, contacts, phase.motion.start);
  resolve_contacts(settings.largest_thickness, response, end);
  push_apart(response, end);
  for (int round = 0; round < 2; ++round) keep_to_limits(phase, settings, response, end);
  return response;
}

static FailSafeResult let_nothing_through(const NarrowPhase& phase, const ContactSettings& settings,
                                          Proximity& proximity, Profile& profile, std::vector<Vec3>& end) {
  timed(profile, Phase::broad, [&] { find_pairs(phase, settings, proximity); });
  return timed(profile, Phase::fail_safe, [&] {
    return settings.fail_safe ? hold_back(phase, proximity, settings.least_gap, end) : let_go(phase.geometry);
  });
}

static void resolve_anew(const NarrowPhase& phase, const ContactSettings& settings, Proximity& proximity,
                         Profile& profile, bool with_limits, std::vector<Vec3>& end) {
  const std::vector<Contact> contacts =
      timed(profile, Phase::narrow, [&] { return find_contacts(phase, proximity); });
  timed(profile, Phase::response, [&] {
    Response response = begin_response(phase.geometry, contacts, phase.motion.start);
    resolve_contacts(settings.largest_thickness, response, end);
    if (with_limits) keep_to_limits(phase, settings, response, end);
  });
}

// Where the fail-safe has to hold points back, the response has left contacts unresolved, or made new ones:
// it hears of them first. A point that is held stays where it is in space while its cloth is carried on, and
// edges at it stretch to a multiple of their length.
static FailSafeResult settle(const NarrowPhase& phase, const ContactSettings& settings, Proximity& proximity,
                             Profile& profile, std::vector<Vec3>& end) {
  constexpr int most_rounds = 6, rounds_with_limits = 3;  // in the end, edges are less than passing through
  std::vector<Vec3> wanted = end;
  FailSafeResult held = let_nothing_through(phase, settings, proximity, profile, end);
  for (int round = 0; round < most_rounds && held.limited_vertices > 0; ++round) {
    const std::vector<Vec3> reached = std::exchange(end, wanted);
    resolve_anew(phase, settings, proximity, profile, round < rounds_with_limits, end);
    if (end == wanted) {  // nothing can give way
      end = reached;
      break;
    }
    wanted = end;
    held = let_nothing_through(phase, settings, proximity, profile, end);
  }
  return held;
}

ContactStepResult step_contacts(const ContactGeometry& geometry, const ContactSettings& settings,
                                const std::vector<BodyMotion>& bodies, const std::vector<Vec3>& start,
                                Proximity& proximity, Profile& profile, std::vector<Vec3>& end) {
  const NarrowPhase phase{geometry, bodies, {start, end}, settings.healing};
  ContactStepResult result;
  timed(profile, Phase::broad, [&] { find_pairs(phase, settings, proximity); });
  const std::vector<Contact> contacts =
      timed(profile, Phase::narrow, [&] { return find_contacts(phase, proximity); });
  result.contacts = static_cast<int>(contacts.size());
  const Response response =
      timed(profile, Phase::response, [&] { return respond(phase, settings, contacts, end); });
  const FailSafeResult held = settle(phase, settings, proximity, profile, end);
  timed(profile, Phase::response, [&] { result.push = pushed_ways(response, end); });
  result.body_progress = held.body_progress;
  result.limited_vertices = held.limited_vertices;
  timed(profile, Phase::broad, [&] { follow_motion(phase.motion, proximity); });
  return result;
}

}  // namespace drape
