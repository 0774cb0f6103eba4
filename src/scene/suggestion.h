#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drape {

// The least number of letters to insert, delete, replace or swap with their neighbour that turns `a` into
// `b`.
int edit_distance(std::string_view a, std::string_view b);

// What stands after a word that is not among `known`: "; did you mean `friction`?" where one is near enough,
// "; known keys: a, b" otherwise (`plural` names what they are).
std::string suggestion(std::string_view word, const std::vector<std::string_view>& known,
                       std::string_view plural);

// "a, b, c"
std::string join(const std::vector<std::string_view>& words);

}  // namespace drape
