#pragma once

#include "render/gl_objects.h"
#include "render/view.h"

namespace drape::render {

// The places of the attributes in shaders/surface.vert and shaders/depth.vert.
inline constexpr GLuint position_attribute = 0;
inline constexpr GLuint normal_attribute = 1;
inline constexpr GLuint uv_attribute = 2;

// One surface in the buffers of OpenGL.
struct SurfaceBuffers {
  GlObject vertex_array;
  GlObject positions;
  GlObject normals;
  GlObject uvs;
  GlObject triangles;
  GLsizei index_count = 0;
};

// Throws std::invalid_argument where the arrays of the surface do not fit each other.
SurfaceBuffers upload_surface(const GlFunctions& gl, const Surface& surface);
void draw_surface(const GlFunctions& gl, const SurfaceBuffers& buffers);

// The ground as two triangles.
Surface make_ground_surface(const View& view);

}  // namespace drape::render
