#pragma once

#include "core/rigid_motion.h"
#include "scene/section.h"

namespace drape {

// A key `place: {at, rotate}` of the section: metres and degrees.
void read_place(const Section& owner, RigidMotion& motion);

// A key `animate: {translate, rotate_x, rotate_y, rotate_z}`: frame n is at the time n / fps.
void read_animation(const Section& owner, double fps, RigidMotion& motion);

}  // namespace drape
