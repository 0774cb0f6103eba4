#pragma once

#include <string_view>

namespace drape {

// Whether a glTF file, as text or binary, holds animations whose keys are joined by cubic splines. assimp
// does not say so, and drops what makes them curves.
bool has_spline_keys(std::string_view file);

}  // namespace drape
