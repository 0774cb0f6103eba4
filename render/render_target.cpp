#include "render/render_target.h"

#include <string>

#include "render/render_error.h"

namespace drape::render {

static void check_size(const GlFunctions& gl, int width, int height) {
  GLint limit = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (width >= 1 && height >= 1 && width <= limit && height <= limit) return;
  throw RenderError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels can't be drawn: each side must be from 1 to " + std::to_string(limit));
}

static void attach(const GlFunctions& gl, GLenum point, const GlObject& texture) {
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture.id(), 0);
}

static void check_complete(const GlFunctions& gl, const RenderTarget& target) {
  const bool complete = gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (gl.GetError() == GL_NO_ERROR && complete) return;
  throw RenderError("OpenGL gives no framebuffer of " + std::to_string(target.width) + " x " +
                    std::to_string(target.height) + " pixels: is there enough memory?");
}

static RenderTarget start_target(const GlFunctions& gl, GLint format, int width, int height) {
  check_size(gl, width, height);
  RenderTarget target{width, height, make_framebuffer(gl), make_texture(gl, format, width, height), {}};
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
  return target;
}

RenderTarget make_shadow_target(const GlFunctions& gl, int width, int height) {
  RenderTarget target = start_target(gl, GL_DEPTH_COMPONENT16, width, height);
  attach(gl, GL_DEPTH_ATTACHMENT, target.texture);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  check_complete(gl, target);
  return target;
}

RenderTarget make_picture_target(const GlFunctions& gl, GLint format, int width, int height) {
  RenderTarget target = start_target(gl, format, width, height);
  attach(gl, GL_COLOR_ATTACHMENT0, target.texture);
  check_complete(gl, target);
  return target;
}

RenderTarget make_picture_target_with_depth(const GlFunctions& gl, GLint format, int width, int height) {
  RenderTarget target = make_picture_target(gl, format, width, height);
  target.depth_buffer = make_texture(gl, GL_DEPTH_COMPONENT32F, width, height);
  attach(gl, GL_DEPTH_ATTACHMENT, target.depth_buffer);
  check_complete(gl, target);
  return target;
}

void bind_target(const GlFunctions& gl, const RenderTarget& target) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
  gl.Viewport(0, 0, target.width, target.height);
}

}  // namespace drape::render
