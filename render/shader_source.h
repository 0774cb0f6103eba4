#pragma once

#include <string>
#include <string_view>

namespace drape::render {

// The text of a file of shaders/, by its name; cmake/EmbedShaders.cmake writes the definition.
std::string_view shader_source(std::string_view name);

}  // namespace drape::render
