#pragma once

#include <vector>

#include "contact/active_contacts.h"
#include "contact/contact_geometry.h"
#include "contact/proximity.h"
#include "core/profile.h"

namespace drape {

struct ContactSettings {
  double pad = 0;        // m: how far vertices may stray before the broad phase is done again
  double cell_size = 0;  // m
  double largest_thickness = 0;
  double least_gap = 1e-5;  // m: what the fail-safe keeps
};
// From the cloths' mean edge length and thickness.
ContactSettings contact_settings(const ContactGeometry& geometry);

// What contact keeps from step to step: lists of the broad phase. It is cleared at each frame's start: the
// order of a list's pairs, which is that of the response, depends on when it was built, and a resumed run
// must do the same as one that never stopped.
struct ContactCache {
  std::vector<ProximityList> lists;
};
ContactCache empty_contact_cache(const ContactGeometry& geometry);

struct ContactStepResult {
  std::vector<Vec3> push;  // m: what of the way is not velocity
  std::vector<double> body_progress;
  int contacts = 0;
  int limited_vertices = 0;
};

// Section 5 of the paper: x** -> x(t+h). `end` comes with the elastic positions of the cloths and the aims of
// the colliders, and leaves with what they reach.
ContactStepResult step_contacts(const ContactGeometry& geometry, const ContactSettings& settings,
                                const std::vector<BodyMotion>& bodies, const std::vector<Vec3>& start,
                                ContactCache& cache, Profile& profile, std::vector<Vec3>& end);

}  // namespace drape
