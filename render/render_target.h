#pragma once

#include "render/gl_objects.h"

namespace drape::render {

// A framebuffer object with its texture (colour or depth, by the format) and, for what is drawn in depth
// order, a depth buffer of its own.
struct RenderTarget {
  int width = 0;
  int height = 0;
  GlObject framebuffer;
  GlObject texture;
  GlObject depth_buffer;
};

// Throw RenderError where the memory or the limits of OpenGL do not allow it.
RenderTarget make_shadow_target(const GlFunctions& gl, int width, int height);
RenderTarget make_picture_target(const GlFunctions& gl, GLint format, int width, int height);
RenderTarget make_picture_target_with_depth(const GlFunctions& gl, GLint format, int width, int height);

// Drawing goes to the target, over its whole size, from now on.
void bind_target(const GlFunctions& gl, const RenderTarget& target);

}  // namespace drape::render
