#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "mesh/polygon_soup.h"

namespace drape {

using ByteSink = std::function<void(std::string_view)>;

// A soup and its shapes as bytes, to pass from one process of this machine to another: piece by piece out of
// their own memory, since shapes may fill most of what a process may have.
void write_bytes(const SoupInShapes& soup, const ByteSink& write);

// Trusts nothing: nothing where sizes disagree, limits are exceeded, an index is out of range, a coordinate
// is not usable, or a polygon has fewer than three corners.
std::optional<SoupInShapes> soup_from_bytes(std::string_view bytes);

}  // namespace drape
