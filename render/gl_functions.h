#pragma once

// The OpenGL functions that the room uses, as one list of names. Loading them ourselves lets any source of
// contexts serve; the usual loaders know nothing of OSMesa.

#include <GL/glcorearb.h>

namespace drape::render {

class Context;

// X(member, type): the member's name is the function's without its prefix.
#define DRAPE_GL_FUNCTIONS(X)                                  \
  X(ActiveTexture, PFNGLACTIVETEXTUREPROC)                     \
  X(AttachShader, PFNGLATTACHSHADERPROC)                       \
  X(BindBuffer, PFNGLBINDBUFFERPROC)                           \
  X(BindBufferBase, PFNGLBINDBUFFERBASEPROC)                   \
  X(BindFramebuffer, PFNGLBINDFRAMEBUFFERPROC)                 \
  X(BindTexture, PFNGLBINDTEXTUREPROC)                         \
  X(BindVertexArray, PFNGLBINDVERTEXARRAYPROC)                 \
  X(BlendFunc, PFNGLBLENDFUNCPROC)                             \
  X(BufferData, PFNGLBUFFERDATAPROC)                           \
  X(CheckFramebufferStatus, PFNGLCHECKFRAMEBUFFERSTATUSPROC)   \
  X(Clear, PFNGLCLEARPROC)                                     \
  X(ClearColor, PFNGLCLEARCOLORPROC)                           \
  X(ColorMask, PFNGLCOLORMASKPROC)                             \
  X(CompileShader, PFNGLCOMPILESHADERPROC)                     \
  X(CreateProgram, PFNGLCREATEPROGRAMPROC)                     \
  X(CreateShader, PFNGLCREATESHADERPROC)                       \
  X(CullFace, PFNGLCULLFACEPROC)                               \
  X(DeleteBuffers, PFNGLDELETEBUFFERSPROC)                     \
  X(DeleteFramebuffers, PFNGLDELETEFRAMEBUFFERSPROC)           \
  X(DeleteProgram, PFNGLDELETEPROGRAMPROC)                     \
  X(DeleteShader, PFNGLDELETESHADERPROC)                       \
  X(DeleteTextures, PFNGLDELETETEXTURESPROC)                   \
  X(DeleteVertexArrays, PFNGLDELETEVERTEXARRAYSPROC)           \
  X(DepthFunc, PFNGLDEPTHFUNCPROC)                             \
  X(Disable, PFNGLDISABLEPROC)                                 \
  X(DrawArrays, PFNGLDRAWARRAYSPROC)                           \
  X(DrawBuffer, PFNGLDRAWBUFFERPROC)                           \
  X(DrawElements, PFNGLDRAWELEMENTSPROC)                       \
  X(Enable, PFNGLENABLEPROC)                                   \
  X(EnableVertexAttribArray, PFNGLENABLEVERTEXATTRIBARRAYPROC) \
  X(FramebufferTexture2D, PFNGLFRAMEBUFFERTEXTURE2DPROC)       \
  X(GenBuffers, PFNGLGENBUFFERSPROC)                           \
  X(GenFramebuffers, PFNGLGENFRAMEBUFFERSPROC)                 \
  X(GenTextures, PFNGLGENTEXTURESPROC)                         \
  X(GenVertexArrays, PFNGLGENVERTEXARRAYSPROC)                 \
  X(GetError, PFNGLGETERRORPROC)                               \
  X(GetIntegerv, PFNGLGETINTEGERVPROC)                         \
  X(GetProgramInfoLog, PFNGLGETPROGRAMINFOLOGPROC)             \
  X(GetProgramiv, PFNGLGETPROGRAMIVPROC)                       \
  X(GetShaderInfoLog, PFNGLGETSHADERINFOLOGPROC)               \
  X(GetShaderiv, PFNGLGETSHADERIVPROC)                         \
  X(GetUniformBlockIndex, PFNGLGETUNIFORMBLOCKINDEXPROC)       \
  X(GetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC)           \
  X(LinkProgram, PFNGLLINKPROGRAMPROC)                         \
  X(PixelStorei, PFNGLPIXELSTOREIPROC)                         \
  X(PolygonOffset, PFNGLPOLYGONOFFSETPROC)                     \
  X(ReadBuffer, PFNGLREADBUFFERPROC)                           \
  X(ReadPixels, PFNGLREADPIXELSPROC)                           \
  X(ShaderSource, PFNGLSHADERSOURCEPROC)                       \
  X(TexImage2D, PFNGLTEXIMAGE2DPROC)                           \
  X(TexParameteri, PFNGLTEXPARAMETERIPROC)                     \
  X(Uniform1f, PFNGLUNIFORM1FPROC)                             \
  X(Uniform1i, PFNGLUNIFORM1IPROC)                             \
  X(Uniform3f, PFNGLUNIFORM3FPROC)                             \
  X(UniformBlockBinding, PFNGLUNIFORMBLOCKBINDINGPROC)         \
  X(UniformMatrix4fv, PFNGLUNIFORMMATRIX4FVPROC)               \
  X(UseProgram, PFNGLUSEPROGRAMPROC)                           \
  X(VertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC)         \
  X(Viewport, PFNGLVIEWPORTPROC)

struct GlFunctions {
#define DRAPE_DECLARE(name, type) type name = nullptr;
  DRAPE_GL_FUNCTIONS(DRAPE_DECLARE)
#undef DRAPE_DECLARE
};

// Throws RenderError where one is missing.
GlFunctions load_gl_functions(const Context& context);

}  // namespace drape::render
