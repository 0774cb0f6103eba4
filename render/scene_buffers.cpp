#include "render/scene_buffers.h"

namespace drape::render {

SceneBuffers upload_scene(const GlFunctions& gl, const std::vector<Surface>& surfaces, const View& view) {
  SceneBuffers scene{surfaces, {}, {}, bounding_sphere(surfaces)};
  for (const Surface& surface : surfaces) scene.buffers.push_back(upload_surface(gl, surface));
  if (view.ground.visible) scene.ground = upload_surface(gl, make_ground_surface(view));
  return scene;
}

static void use_depth_program(const GlFunctions& gl, const ShaderProgram& program,
                              const Mat4f& clip_from_world) {
  gl.Enable(GL_DEPTH_TEST);
  program.use();
  program.set("clip_from_position", clip_from_world);
}

// Of what is solid only the side towards the viewer, or towards the light: the other one lies behind it.
static void draw_near_side(const GlFunctions& gl, const Surface& surface, const SurfaceBuffers& buffers) {
  if (!surface.two_sided) gl.Enable(GL_CULL_FACE);
  draw_surface(gl, buffers);
  gl.Disable(GL_CULL_FACE);
}

void draw_shadow_depth(const GlFunctions& gl, const ShaderProgram& depth_program,
                       const Mat4f& clip_from_world, const SceneBuffers& scene) {
  use_depth_program(gl, depth_program, clip_from_world);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(1, 1);
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
    draw_near_side(gl, scene.surfaces[i], scene.buffers[i]);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
}

void draw_seen_depth(const GlFunctions& gl, const ShaderProgram& depth_program, const Mat4f& clip_from_world,
                     const SceneBuffers& scene) {
  use_depth_program(gl, depth_program, clip_from_world);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
    draw_near_side(gl, scene.surfaces[i], scene.buffers[i]);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

static void draw_surfaces(const GlFunctions& gl, SurfacePrograms& programs, const SceneBuffers& scene) {
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    programs.use_for(scene.surfaces[i]);
    draw_near_side(gl, scene.surfaces[i], scene.buffers[i]);
  }
}

// Drawn after the surfaces, which hide much of it, and behind what lies on it.
static void draw_ground(const GlFunctions& gl, SurfacePrograms& programs, const Ground& ground,
                        const SceneBuffers& scene) {
  programs.use_for(ground);
  gl.Enable(GL_CULL_FACE);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(1, 4);
  draw_surface(gl, scene.ground);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  gl.Disable(GL_CULL_FACE);
}

void draw_radiance(const GlFunctions& gl, SurfacePrograms& programs, const Ground& ground,
                   const SceneBuffers& scene) {
  gl.Enable(GL_DEPTH_TEST);
  draw_surfaces(gl, programs, scene);
  if (ground.visible) draw_ground(gl, programs, ground, scene);
}

}  // namespace drape::render
