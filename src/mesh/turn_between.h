#pragma once

#include "core/vector.h"

namespace drape {

// The turn that is a share from 0 to 1 of the shorter way from one turn to another, at an even pace (slerp),
// with the same bits on every machine: arc cosines and sines of libm differ in the last one. Takes and gives
// quaternions of length 1.
Quaternion turn_between(const Quaternion& from, const Quaternion& to, double share);

}  // namespace drape
