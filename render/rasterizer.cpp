#include "render/rasterizer.h"

#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>

#include "render/context.h"
#include "render/pass_uniforms.h"
#include "render/render_target.h"
#include "render/scene_buffers.h"

namespace drape::render {

static constexpr int sun_map_size = 1536;
static constexpr int sky_map_size = 1024;

// The targets that have the size of the picture: one pass, the sum of the passes, and what a screen shows.
struct PictureTargets {
  RenderTarget pass;
  RenderTarget sum;
  RenderTarget display;
};

static PictureTargets make_picture_targets(const GlFunctions& gl, int width, int height) {
  return {make_picture_target_with_depth(gl, GL_RGBA16F, width, height),
          make_picture_target(gl, GL_RGBA32F, width, height),
          make_picture_target(gl, GL_RGBA8, width, height)};
}

struct Rasterizer::State {
  Context context;
  GlFunctions gl = load_gl_functions(context);
  SurfacePrograms surface_programs{gl};
  ShaderProgram depth_program{gl, "", {"depth.vert"}, {"depth.frag"}};
  ShaderProgram add_program{gl, "", {"fullscreen.vert"}, {"add.frag"}};
  ShaderProgram develop_program{gl, "", {"fullscreen.vert"}, {"noise.glsl", "develop.frag"}};
  GlObject no_attributes = make_vertex_array(gl);
  GlObject pass_block = make_buffer(gl);
  RenderTarget sun_map = make_shadow_target(gl, sun_places* sun_map_size, sun_map_size);
  RenderTarget sky_map = make_shadow_target(gl, sky_directions* sky_map_size, sky_map_size);
  std::optional<PictureTargets> targets;

  State();
  ~State() { context.make_current(); }
  void fit_targets(int width, int height);
  void bind_texture(GLint unit, const RenderTarget& target) const;
  void draw_shadow_maps(const RenderTarget& map, std::span<const LightProjection> lights,
                        const SceneBuffers& scene) const;
  void draw_pass(const SceneBuffers& scene, const View& view, const Settings& settings,
                 const PassSample& sample);
  void draw_fullscreen() const;
  void add_pass() const;
  void develop(const View& view, int passes) const;
};

Rasterizer::State::State() {
  gl.DepthFunc(GL_LEQUAL);
  gl.CullFace(GL_BACK);
  gl.ClearColor(0, 0, 0, 0);
  gl.BlendFunc(GL_ONE, GL_ONE);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  bind_texture(sun_map_unit, sun_map);
  bind_texture(sky_map_unit, sky_map);
}

void Rasterizer::State::fit_targets(int width, int height) {
  if (targets && targets->pass.width == width && targets->pass.height == height) return;
  targets.reset();
  gl.ActiveTexture(GL_TEXTURE0 + picture_unit);
  targets = make_picture_targets(gl, width, height);
}

void Rasterizer::State::bind_texture(GLint unit, const RenderTarget& target) const {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_2D, target.texture.id());
}

void Rasterizer::State::draw_shadow_maps(const RenderTarget& map, std::span<const LightProjection> lights,
                                         const SceneBuffers& scene) const {
  bind_target(gl, map);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    gl.Viewport(static_cast<GLint>(i) * map.height, 0, map.height, map.height);
    draw_shadow_depth(gl, depth_program, lights[i].clip_from_world, scene);
  }
}

void Rasterizer::State::draw_pass(const SceneBuffers& scene, const View& view, const Settings& settings,
                                  const PassSample& sample) {
  const PassLights lights = aim_lights(view, sample, scene.bounds, sun_map_size, sky_map_size);
  draw_shadow_maps(sun_map, lights.sun, scene);
  draw_shadow_maps(sky_map, lights.sky, scene);
  const PassUniforms uniforms = pass_uniforms(view, settings, scene.bounds, sample, lights);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, pass_block_binding, pass_block.id());
  gl.BufferData(GL_UNIFORM_BUFFER, sizeof uniforms, &uniforms, GL_STREAM_DRAW);
  bind_target(gl, targets->pass);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_seen_depth(gl, depth_program, uniforms.clip_from_world, scene);
  draw_radiance(gl, surface_programs, view.ground, scene);
}

void Rasterizer::State::draw_fullscreen() const {
  gl.Disable(GL_DEPTH_TEST);
  gl.BindVertexArray(no_attributes.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void Rasterizer::State::add_pass() const {
  bind_target(gl, targets->sum);
  bind_texture(picture_unit, targets->pass);
  gl.Enable(GL_BLEND);
  add_program.use();
  draw_fullscreen();
  gl.Disable(GL_BLEND);
}

void Rasterizer::State::develop(const View& view, int passes) const {
  bind_target(gl, targets->display);
  bind_texture(picture_unit, targets->sum);
  develop_program.use();
  develop_program.set("exposure", view.exposure);
  develop_program.set("share_of_pass", 1.0f / static_cast<float>(passes));
  develop_program.set("backdrop", linear_from_srgb(view.backdrop));
  draw_fullscreen();
}

// OpenGL's rows run from the bottom.
static Image read_picture(const GlFunctions& gl, const RenderTarget& target) {
  Image image{target.width, target.height, {}};
  const std::ptrdiff_t row = 3 * static_cast<std::ptrdiff_t>(target.width);
  image.rgb.resize(static_cast<std::size_t>(row * target.height));
  gl.ReadPixels(0, 0, target.width, target.height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  auto top = image.rgb.begin();
  for (auto bottom = image.rgb.end() - row; top < bottom; top += row, bottom -= row) {
    std::swap_ranges(top, top + row, bottom);
  }
  return image;
}

Rasterizer::Rasterizer() : state_(std::make_unique<State>()) {}
Rasterizer::~Rasterizer() = default;

Image Rasterizer::draw(const std::vector<Surface>& surfaces, const View& view, const Settings& settings) {
  if (settings.passes < 1) throw std::invalid_argument("a picture needs at least one pass");
  State& state = *state_;
  state.context.make_current();
  state.fit_targets(settings.width, settings.height);
  const SceneBuffers scene = upload_scene(state.gl, surfaces, view);
  bind_target(state.gl, state.targets->sum);
  state.gl.Clear(GL_COLOR_BUFFER_BIT);
  for (int pass = 0; pass < settings.passes; ++pass) {
    state.draw_pass(scene, view, settings, sample_pass(pass, settings.passes));
    state.add_pass();
  }
  state.develop(view, settings.passes);
  return read_picture(state.gl, state.targets->display);
}

}  // namespace drape::render
