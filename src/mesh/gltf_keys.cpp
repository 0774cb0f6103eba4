#include "mesh/gltf_keys.h"

namespace drape {

static std::string_view without_blanks_at_end(std::string_view text) {
  return text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
}

static bool ends_with_key(std::string_view text, std::string_view key) {
  text = without_blanks_at_end(text);
  if (!text.ends_with(':')) return false;
  text.remove_suffix(1);
  return without_blanks_at_end(text).ends_with(key);
}

bool has_spline_keys(std::string_view file) {
  constexpr std::string_view value = "\"CUBICSPLINE\"";
  for (std::size_t at = file.find(value); at != file.npos; at = file.find(value, at + value.size()))
    if (ends_with_key(file.substr(0, at), "\"interpolation\"")) return true;
  return false;
}

}  // namespace drape
