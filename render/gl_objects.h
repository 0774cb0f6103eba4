#pragma once

#include <utility>

#include "render/gl_functions.h"

namespace drape::render {

// Owns one OpenGL object. Its context must be current when it is destroyed.
class GlObject {
 public:
  using Release = void (*)(const GlFunctions& gl, GLuint id);
  GlObject() = default;
  GlObject(const GlFunctions& gl, GLuint id, Release release) : gl_(&gl), id_(id), release_(release) {}
  GlObject(GlObject&& other) noexcept { swap(other); }
  GlObject& operator=(GlObject&& other) noexcept {
    swap(other);
    return *this;
  }
  ~GlObject() {
    if (id_ != 0) release_(*gl_, id_);
  }
  GLuint id() const { return id_; }

 private:
  void swap(GlObject& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    std::swap(release_, other.release_);
  }
  const GlFunctions* gl_ = nullptr;
  GLuint id_ = 0;
  Release release_ = nullptr;
};

GlObject make_buffer(const GlFunctions& gl);
GlObject make_vertex_array(const GlFunctions& gl);
GlObject make_framebuffer(const GlFunctions& gl);
// Storage of one level without filtering; what lies outside is undefined (shaders fetch texels by index).
GlObject make_texture(const GlFunctions& gl, GLint internal_format, int width, int height);

}  // namespace drape::render
