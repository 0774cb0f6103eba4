#pragma once

namespace drape {

// Times of a scene are multiples of a frame's duration: what differs by less (s) is rounding.
constexpr double same_time = 1e-9;

}  // namespace drape
