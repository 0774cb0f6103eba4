#pragma once

#include <vector>

#include "render/projection.h"
#include "render/shader_program.h"
#include "render/surface_buffers.h"
#include "render/surface_programs.h"

namespace drape::render {

// What is drawn: the surfaces as given and, in the same order, their buffers; the ground apart from them.
struct SceneBuffers {
  const std::vector<Surface>& surfaces;
  std::vector<SurfaceBuffers> buffers;
  SurfaceBuffers ground;
  Sphere bounds;
};

SceneBuffers upload_scene(const GlFunctions& gl, const std::vector<Surface>& surfaces, const View& view);

// Depth alone, for a shadow map: a little away from the light, so that no surface shades itself.
void draw_shadow_depth(const GlFunctions& gl, const ShaderProgram& depth_program,
                       const Mat4f& clip_from_world, const SceneBuffers& scene);

// Depth alone, of what the camera sees.
void draw_seen_depth(const GlFunctions& gl, const ShaderProgram& depth_program, const Mat4f& clip_from_world,
                     const SceneBuffers& scene);

// Radiance, into the bound target, as the bound block of pass uniforms says; its depth must have been drawn,
// so that only what is seen is shaded. Alpha is the share of the pixel that is not backdrop; colours are
// multiplied by it.
void draw_radiance(const GlFunctions& gl, SurfacePrograms& programs, const Ground& ground,
                   const SceneBuffers& scene);

}  // namespace drape::render
