#pragma once

#include <vector>

#include "contact/active_contacts.h"
#include "contact/contact_geometry.h"
#include "contact/contact_memory.h"
#include "contact/edge_limits.h"
#include "contact/proximity.h"
#include "core/profile.h"

namespace drape {

struct ContactSettings {
  ProximityMargins margins;
  double least_gap = 1e-5;  // m: what the fail-safe keeps
  bool fail_safe = true;
  double healing = 0;   // share of the thickness by which old overlap may heal in a step
  double held_way = 0;  // m: how far what held a contact in the last step parts its sides again at most
  std::int64_t push_pause = 0;  // steps for which a contact is left alone that was pushed in vain
  EdgeLimits edge_limits = {};
};
// From the cloths' mean edge length, and the step in seconds.
ContactSettings contact_settings(const ContactGeometry& geometry, double step);

struct ContactStepResult {
  std::vector<Vec3> push;  // m: what of the way is not velocity
  std::vector<double> body_progress;
  int contacts = 0;
  int limited_vertices = 0;
};

// Kept from step to step for speed alone: a new one gives the same.
struct ContactScratch {
  Proximity proximity;
  std::vector<Contact> contacts;
};
ContactScratch start_contacts(const ContactGeometry& geometry);

// Section 5 of the paper: x** -> x(t+h). `end` comes with the elastic positions of the cloths and the aims of
// the colliders, and leaves with what they reach. `remembered` comes with what contacts keep of the last
// step, and leaves with what they keep of this one. (Impulses of contacts that are resolved again before the
// fail-safe are not kept.)
ContactStepResult step_contacts(const ContactGeometry& geometry, const ContactSettings& settings,
                                const std::vector<BodyMotion>& bodies, const std::vector<Vec3>& start,
                                ContactScratch& scratch, std::vector<RememberedContact>& remembered,
                                Profile& profile, std::vector<Vec3>& end);

}  // namespace drape
