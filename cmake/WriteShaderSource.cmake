# Writes OUTPUT, a C++ source file that holds the text of FILES. Run by embed_shaders.
set(entries "")
foreach(file ${FILES})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND entries "  if (name == \"${name}\") return R\"glsl(${text})glsl\";\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"render/shader_source.h\"

#include <stdexcept>

namespace drape::render {

std::string_view shader_source(std::string_view name) {
${entries}  throw std::invalid_argument(\"no shader is named \" + std::string(name));
}

}  // namespace drape::render
")
