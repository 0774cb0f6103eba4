#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mesh/polygon_soup.h"

namespace drape {

// A soup and its shapes as bytes, to pass from one process of this machine to another.
std::string to_bytes(const SoupInShapes& soup);

// Trusts nothing: nothing where sizes disagree, limits are exceeded, an index is out of range, a coordinate
// is not usable, or a polygon has fewer than three corners.
std::optional<SoupInShapes> soup_from_bytes(std::string_view bytes);

}  // namespace drape
