#pragma once

#include "simulation/world.h"

namespace drape {

// Cloth that lies still, and that nothing stirs, is left where it is: a heap at rest costs hardly anything,
// and is quite still. What only creeps by less than this is taken to have come to its rest.

// How far (m) points may go in a third of a second and lie still: a fiftieth of the mean edge of the cloth
// with the shortest edges, and no more than half a millimetre.
double largest_still_way(const Sheet& sheet);

// Whether something other than cloth acts otherwise at the end of the frame that comes after the state than
// at its begin: a collider or a pin on its way, one that lags behind it, a pin that takes hold or lets go, a
// seam that is drawn in, gusts.
bool is_stirred(const World& world, const State& state);

// Whether cloth has lain still for half a second, and nine frames: at the end of none of them a point was
// farther than that from where it was a third of a second before, and in the end none gathered speed. By way
// and not by speed: points within a heap may tremble by less than can be seen. Never for cloth that nothing
// holds, nor where the input does not let it sleep.
bool lies_still(const World& world, const State& state);

// Brings up to date since when cloth has lain still: to be called at the end of each frame that is advanced.
void watch_stillness(const World& world, bool stirred, State& state);

// The next frame of cloth that lies still and is not stirred: only time goes on.
void stay(const World& world, State& state);

}  // namespace drape
