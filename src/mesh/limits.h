#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace drape {

// What one mesh may hold. Corners of this many triangles still have numbers of type int.
inline constexpr std::size_t most_points = 5'000'000;
inline constexpr std::size_t most_triangles = 20'000'000;
inline constexpr std::size_t most_corners = 3 * most_triangles;
inline constexpr std::uintmax_t most_file_bytes = std::uintmax_t{2} << 30;

// Beyond this, products of coordinates leave the range of float. False for NaN.
inline constexpr double largest_coordinate = 1e9;
inline bool is_usable_coordinate(double x) { return std::abs(x) <= largest_coordinate; }

}  // namespace drape
