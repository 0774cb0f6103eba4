#include <GL/osmesa.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "render/context.h"
#include "render/rasterizer.h"
#include "render/render_error.h"

namespace drape::render {

// OSMesa wants a buffer of its own to draw into; nothing is ever drawn there.
static constexpr int unused_size = 4;

// llvmpipe's own limit.
static constexpr int most_threads = 16;

struct Context::Handle {
  OSMesaContext context = nullptr;
  std::array<unsigned char, std::size_t{4} * unused_size * unused_size> unused{};
};

static OSMesaContext create_core_context() {
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  return OSMesaCreateContextAttribs(attributes, nullptr);
}

Context::Context() : handle_(std::make_unique<Handle>()) {
  handle_->context = create_core_context();
  if (!handle_->context) {
    throw RenderError(
        "OSMesa gives no OpenGL 3.3 core context: install Mesa's off-screen library with llvmpipe "
        "(Debian: apt install libosmesa6), version 12 to 25.0");
  }
  make_current();
}

Context::~Context() {
  OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  OSMesaDestroyContext(handle_->context);
}

void Context::make_current() {
  if (!OSMesaMakeCurrent(handle_->context, handle_->unused.data(), GL_UNSIGNED_BYTE, unused_size,
                         unused_size)) {
    throw RenderError("OSMesa's OpenGL context can't be made current");
  }
}

Context::Function Context::function(const char* name) const {
  const OSMESAproc address = OSMesaGetProcAddress(name);
  if (!address) throw RenderError(std::string("this OpenGL has no function ") + name);
  return address;
}

void configure_software_rendering(int threads) {
  const int keep_what_the_user_set = 0;
  const int helpers = threads > 1 ? std::min(threads, most_threads) : 0;
  ::setenv("LP_NUM_THREADS", std::to_string(helpers).c_str(), keep_what_the_user_set);
}

}  // namespace drape::render
