#pragma once

#include <cstddef>

namespace drape {

// What one mesh may hold. Corners of this many triangles still have numbers of type int.
inline constexpr std::size_t most_points = 5'000'000;
inline constexpr std::size_t most_triangles = 20'000'000;

}  // namespace drape
