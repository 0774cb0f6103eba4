#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "core/vector.h"
#include "render/gl_objects.h"

namespace drape::render {

// The texture units and the uniform block that every program finds in the same place.
inline constexpr GLint sun_map_unit = 0;
inline constexpr GLint sky_map_unit = 1;
inline constexpr GLint picture_unit = 2;
inline constexpr GLuint pass_block_binding = 0;

// A linked pair of shaders. Each is put together from `defines` and the files named, in their order.
class ShaderProgram {
 public:
  using Files = std::initializer_list<std::string_view>;
  ShaderProgram(const GlFunctions& gl, const std::string& defines, Files vertex_files, Files fragment_files);

  void use() const { gl_->UseProgram(program_.id()); }
  // The program must be in use. A uniform that the compiler found useless is passed over.
  void set(const char* name, float value) const { gl_->Uniform1f(location(name), value); }
  void set(const char* name, const Vec3f& value) const {
    gl_->Uniform3f(location(name), value.x(), value.y(), value.z());
  }
  void set(const char* name, const Mat4f& value) const {
    gl_->UniformMatrix4fv(location(name), 1, GL_FALSE, value.data());
  }

 private:
  GLint location(const char* name) const { return gl_->GetUniformLocation(program_.id(), name); }
  void bind_shared_places() const;
  const GlFunctions* gl_;
  GlObject program_;
};

}  // namespace drape::render
