#include "render/surface_buffers.h"

#include <stdexcept>

#include "render/projection.h"

namespace drape::render {

static void check_surface(const Surface& surface) {
  const std::size_t count = surface.positions.size();
  const bool fits = surface.normals.size() == count && (surface.uvs.empty() || surface.uvs.size() == count);
  if (!fits) throw std::invalid_argument("a surface needs one normal, and one or no uv, for each position");
  for (const Triangle& triangle : surface.triangles) {
    for (const int corner : triangle) {
      if (corner < 0 || static_cast<std::size_t>(corner) >= count) {
        throw std::invalid_argument("a triangle of a surface names a position that is not there");
      }
    }
  }
}

template <typename Item>
static GlObject upload(const GlFunctions& gl, GLenum target, const std::vector<Item>& items) {
  GlObject buffer = make_buffer(gl);
  gl.BindBuffer(target, buffer.id());
  gl.BufferData(target, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(), GL_STREAM_DRAW);
  return buffer;
}

template <typename Vector>
static GlObject upload_attribute(const GlFunctions& gl, GLuint attribute, const std::vector<Vector>& values) {
  static_assert(sizeof(Vector) == Vector::SizeAtCompileTime * sizeof(float));
  if (values.empty()) return {};
  GlObject buffer = upload(gl, GL_ARRAY_BUFFER, values);
  gl.EnableVertexAttribArray(attribute);
  gl.VertexAttribPointer(attribute, Vector::SizeAtCompileTime, GL_FLOAT, GL_FALSE, 0, nullptr);
  return buffer;
}

SurfaceBuffers upload_surface(const GlFunctions& gl, const Surface& surface) {
  check_surface(surface);
  SurfaceBuffers buffers;
  buffers.vertex_array = make_vertex_array(gl);
  gl.BindVertexArray(buffers.vertex_array.id());
  buffers.positions = upload_attribute(gl, position_attribute, surface.positions);
  buffers.normals = upload_attribute(gl, normal_attribute, surface.normals);
  buffers.uvs = upload_attribute(gl, uv_attribute, surface.uvs);
  buffers.triangles = upload(gl, GL_ELEMENT_ARRAY_BUFFER, surface.triangles);
  buffers.index_count = static_cast<GLsizei>(3 * surface.triangles.size());
  return buffers;
}

void draw_surface(const GlFunctions& gl, const SurfaceBuffers& buffers) {
  if (buffers.index_count == 0) return;
  gl.BindVertexArray(buffers.vertex_array.id());
  gl.DrawElements(GL_TRIANGLES, buffers.index_count, GL_UNSIGNED_INT, nullptr);
}

Surface make_ground_surface(const View& view) {
  const float reach = ground_reach(view.camera);
  const float height = view.ground.height;
  const float x = view.camera.target.x();
  const float z = view.camera.target.z();
  Surface ground;
  ground.positions = {{x - reach, height, z - reach},
                      {x - reach, height, z + reach},
                      {x + reach, height, z + reach},
                      {x + reach, height, z - reach}};
  ground.normals.assign(4, Vec3f(0, 1, 0));
  ground.triangles = {{0, 1, 2}, {0, 2, 3}};
  return ground;
}

}  // namespace drape::render
