#include "contact/contact_step.h"

#include <algorithm>
#include <cmath>
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

// What a step's verbs work on. The motion's end is `end`.
struct Step {
  const NarrowPhase& phase;
  const ContactSettings& settings;
  ContactScratch& scratch;
  Profile& profile;
  std::vector<Vec3>& end;
};

void find_pairs(const Step& step) {
  timed(step.profile, Phase::broad, [&] {
    update_proximity(step.phase.geometry, step.phase.motion, step.settings.margins, step.scratch.proximity);
  });
}

void find_contacts(const Step& step, std::vector<Contact>& contacts) {
  timed(step.profile, Phase::narrow, [&] {
    find_active_pairs(step.phase, step.scratch.proximity, contacts);
    find_plane_contacts(step.phase, contacts);
  });
}

// Firm contacts have the last word.
void keep_to_limits(const Step& step, const Response& response) {
  constexpr int most_rounds = 2;
  const EdgeLimits& limits = step.settings.edge_limits;
  EdgesInDoubt in_doubt = find_edges_out_of_limits(limits, step.end);
  for (int round = 0; round < most_rounds; ++round) {
    pull_within_limits(limits, step.phase.geometry.inverse_masses, in_doubt, step.end);
    const std::vector<char> moved = keep_firm_contacts(response, step.end);
    if (limits.edges.empty() || std::find(moved.begin(), moved.end(), 1) == moved.end()) return;
    for (std::size_t v = 0; v < moved.size(); ++v)
      if (moved[v]) doubt_edges_at(limits, static_cast<int>(v), in_doubt);
  }
}

Response respond(const Step& step, const std::vector<RememberedContact>& remembered,
                 const std::vector<Contact>& contacts) {
  return timed(step.profile, Phase::response, [&] {
    Response response = begin_response(step.phase.geometry, contacts, recall(remembered, contacts),
                                       step.settings.held_way, step.phase.motion.start);
    hold_again(response, step.end);
    resolve_contacts(response, step.end);
    push_apart(response, step.end);
    keep_to_limits(step, response);
    return response;
  });
}

FailSafeResult let_go(const ContactGeometry& geometry) {
  return {std::vector<double>(geometry.vertex_body.size(), 1),
          std::vector<double>(geometry.bodies.size(), 1)};
}

FailSafeResult let_nothing_through(const Step& step) {
  find_pairs(step);
  return timed(step.profile, Phase::fail_safe, [&] {
    return step.settings.fail_safe ? hold_back(step.phase, step.scratch.proximity, step.end)
                                   : let_go(step.phase.geometry);
  });
}

// Limits have their say `limit_rounds` times, contacts after each.
void resolve_anew(const Step& step, int limit_rounds) {
  std::vector<Contact> contacts;
  find_contacts(step, contacts);
  timed(step.profile, Phase::response, [&] {
    Response response = begin_response(step.phase.geometry, contacts, {}, 0, step.phase.motion.start);
    resolve_contacts(response, step.end);
    for (int round = 0; round < limit_rounds; ++round) {
      keep_to_limits(step, response);
      resolve_contacts(response, step.end);
    }
    keep_firm_contacts(response, step.end);
  });
}

// Where the fail-safe has to hold points back, contacts are left unresolved, or the response has made new
// ones: the response is asked again before. A point that is held stays where it is in space while its cloth
// is carried on, and edges at it stretch to a multiple of their length. Limits are asked with the first round
// only: passing through is worse than stretch.
FailSafeResult settle(const Step& step) {
  constexpr int most_rounds = 6, limit_rounds = 3;
  std::vector<Vec3> wanted = step.end;
  FailSafeResult held = let_nothing_through(step);
  for (int round = 0; round < most_rounds && held.limited_vertices > 0; ++round) {
    const std::vector<Vec3> reached = std::exchange(step.end, wanted);
    resolve_anew(step, round == 0 ? limit_rounds : 0);
    if (step.end == wanted) {  // nothing can give way
      step.end = reached;
      break;
    }
    wanted = step.end;
    held = let_nothing_through(step);
  }
  return held;
}

}  // namespace

ContactSettings contact_settings(const ContactGeometry& geometry, double step) {
  constexpr double healing_time = 0.04;      // s: a fold that is pushed open faster strains its edges
  constexpr double held_acceleration = 500;  // m/s2: the weight of fifty layers; a blow is more
  constexpr double pause = 0.25;             // s
  const double edge = mean_cloth_edge(geometry);
  ContactSettings settings;
  settings.healing = step / healing_time;
  settings.held_way = held_acceleration * step * step;
  settings.push_pause = static_cast<std::int64_t>(std::ceil(pause / step));
  settings.margins = {0.2 * edge, 0.35 * edge, 0.5 * edge};
  return settings;
}

ContactScratch start_contacts(const ContactGeometry& geometry) { return {start_proximity(geometry), {}}; }

ContactStepResult step_contacts(const ContactGeometry& geometry, const ContactSettings& settings,
                                const std::vector<BodyMotion>& bodies, const std::vector<Vec3>& start,
                                ContactScratch& scratch, std::vector<RememberedContact>& remembered,
                                Profile& profile, std::vector<Vec3>& end) {
  const NarrowPhase phase{geometry, bodies, {start, end}, settings.healing, settings.least_gap};
  const Step step{phase, settings, scratch, profile, end};
  const std::vector<Contact>& contacts = scratch.contacts;
  find_pairs(step);
  find_contacts(step, scratch.contacts);
  Response response = respond(step, remembered, contacts);
  const FailSafeResult reached = settle(step);
  ContactStepResult result;
  result.contacts = static_cast<int>(contacts.size());
  result.push = timed(profile, Phase::response, [&] {
    std::vector<Vec3> ways = take_pushes(settings.push_pause, response, end);
    remembered = remember(contacts, memories_of(response));
    return ways;
  });
  result.body_progress = reached.body_progress;
  result.limited_vertices = reached.limited_vertices;
  timed(profile, Phase::broad, [&] { follow_motion(phase.motion, scratch.proximity); });
  return result;
}

}  // namespace drape
