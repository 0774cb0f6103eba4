#include "render/shader_program.h"

#include "render/render_error.h"
#include "render/shader_source.h"

namespace drape::render {

static std::string join_source(const std::string& defines, ShaderProgram::Files files) {
  std::string text = "#version 330 core\n" + defines;
  for (const std::string_view file : files) text += std::string("#line 1\n").append(shader_source(file));
  return text;
}

static std::string last_file(ShaderProgram::Files files) { return std::string(*(files.end() - 1)); }

static GlObject compile(const GlFunctions& gl, GLenum stage, const std::string& defines,
                        ShaderProgram::Files files) {
  GlObject shader(gl, gl.CreateShader(stage), [](const GlFunctions& f, GLuint id) { f.DeleteShader(id); });
  const std::string text = join_source(defines, files);
  const char* source = text.c_str();
  gl.ShaderSource(shader.id(), 1, &source, nullptr);
  gl.CompileShader(shader.id());
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled) return shader;
  std::string log(4096, '\0');
  GLsizei length = 0;
  gl.GetShaderInfoLog(shader.id(), static_cast<GLsizei>(log.size()), &length, log.data());
  throw RenderError("the shader " + last_file(files) + " does not compile: " + log.substr(0, length));
}

static void link(const GlFunctions& gl, GLuint program, const std::string& name) {
  gl.LinkProgram(program);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) return;
  std::string log(4096, '\0');
  GLsizei length = 0;
  gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
  throw RenderError("the shader " + name + " does not link: " + log.substr(0, length));
}

ShaderProgram::ShaderProgram(const GlFunctions& gl, const std::string& defines, Files vertex_files,
                             Files fragment_files)
    : gl_(&gl),
      program_(gl, gl.CreateProgram(), [](const GlFunctions& f, GLuint id) { f.DeleteProgram(id); }) {
  const GlObject vertex = compile(gl, GL_VERTEX_SHADER, defines, vertex_files);
  const GlObject fragment = compile(gl, GL_FRAGMENT_SHADER, defines, fragment_files);
  gl.AttachShader(program_.id(), vertex.id());
  gl.AttachShader(program_.id(), fragment.id());
  link(gl, program_.id(), last_file(fragment_files));
  bind_shared_places();
}

void ShaderProgram::bind_shared_places() const {
  use();
  gl_->Uniform1i(location("sun_map"), sun_map_unit);
  gl_->Uniform1i(location("sky_map"), sky_map_unit);
  gl_->Uniform1i(location("picture"), picture_unit);
  const GLuint block = gl_->GetUniformBlockIndex(program_.id(), "Pass");
  if (block != GL_INVALID_INDEX) gl_->UniformBlockBinding(program_.id(), block, pass_block_binding);
}

}  // namespace drape::render
