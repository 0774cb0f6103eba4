#include "render/gl_functions.h"

#include "render/context.h"

namespace drape::render {

GlFunctions load_gl_functions(const Context& context) {
  GlFunctions gl;
#define DRAPE_LOAD(name, type) gl.name = reinterpret_cast<type>(context.function("gl" #name));
  DRAPE_GL_FUNCTIONS(DRAPE_LOAD)
#undef DRAPE_LOAD
  return gl;
}

}  // namespace drape::render
