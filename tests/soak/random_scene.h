#pragma once

#include <cstdint>
#include <string>

namespace drape::soak {

// The text of a scene that holds cloth to the worst that it may meet: layers of any material and thickness
// down to 0.5 mm, thrown, pinned and dragged, among colliders at up to 50 m/s, in gusts. The same seed gives
// the same text everywhere. Nothing in it is through anything at the start but by chance, which `drape
// validate` tells.
std::string random_scene(std::uint64_t seed);

}  // namespace drape::soak
