#pragma once

#include "core/vector.h"
#include "simulation/input.h"

namespace drape {

// The velocity of the air in m/s at a place (m) and a time (s): the mean wind, and gusts that depart from it
// by up to `gust` of its speed along each axis. By Taylor's hypothesis of frozen turbulence (Taylor 1938, The
// Spectrum of Turbulence) gusts are a pattern in space that the mean wind carries along. The same bits on
// every machine; smooth in time and place.
Vec3 wind_at(const WindInput& wind, const Vec3& place, double time);

// Whether it takes hold of cloth at all.
bool has_air(const WindInput& wind);

// Whether the wind is the same at all places and times.
bool is_steady(const WindInput& wind);

}  // namespace drape
