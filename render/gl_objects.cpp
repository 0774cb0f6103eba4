#include "render/gl_objects.h"

namespace drape::render {

GlObject make_buffer(const GlFunctions& gl) {
  GLuint id = 0;
  gl.GenBuffers(1, &id);
  return {gl, id, [](const GlFunctions& functions, GLuint buffer) { functions.DeleteBuffers(1, &buffer); }};
}

GlObject make_vertex_array(const GlFunctions& gl) {
  GLuint id = 0;
  gl.GenVertexArrays(1, &id);
  return {gl, id,
          [](const GlFunctions& functions, GLuint array) { functions.DeleteVertexArrays(1, &array); }};
}

GlObject make_framebuffer(const GlFunctions& gl) {
  GLuint id = 0;
  gl.GenFramebuffers(1, &id);
  return {gl, id,
          [](const GlFunctions& functions, GLuint frame) { functions.DeleteFramebuffers(1, &frame); }};
}

static bool is_depth(GLint internal_format) {
  return internal_format == GL_DEPTH_COMPONENT32F || internal_format == GL_DEPTH_COMPONENT16;
}

GlObject make_texture(const GlFunctions& gl, GLint internal_format, int width, int height) {
  GLuint id = 0;
  gl.GenTextures(1, &id);
  GlObject texture(gl, id, [](const GlFunctions& functions, GLuint t) { functions.DeleteTextures(1, &t); });
  gl.BindTexture(GL_TEXTURE_2D, id);
  const GLenum format = is_depth(internal_format) ? GL_DEPTH_COMPONENT : GL_RGBA;
  gl.TexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, 0, format, GL_FLOAT, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  return texture;
}

}  // namespace drape::render
