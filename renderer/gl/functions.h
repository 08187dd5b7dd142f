// The OpenGL ES entry points that glimt calls, as a table filled by the context itself.
#pragma once

#include <GLES2/gl2.h>
#include <GLES2/gl2ext.h>

#include <functional>

namespace glimt::gl {

using ProcLoader = std::function<void*(const char* name)>;

// name without its prefix, type of the pointer
#define GLIMT_GL_FUNCTIONS(X)                                    \
  X(ActiveTexture, PFNGLACTIVETEXTUREPROC)                       \
  X(AttachShader, PFNGLATTACHSHADERPROC)                         \
  X(BindAttribLocation, PFNGLBINDATTRIBLOCATIONPROC)             \
  X(BindBuffer, PFNGLBINDBUFFERPROC)                             \
  X(BindFramebuffer, PFNGLBINDFRAMEBUFFERPROC)                   \
  X(BindRenderbuffer, PFNGLBINDRENDERBUFFERPROC)                 \
  X(BindTexture, PFNGLBINDTEXTUREPROC)                           \
  X(BlendFunc, PFNGLBLENDFUNCPROC)                               \
  X(BufferData, PFNGLBUFFERDATAPROC)                             \
  X(CheckFramebufferStatus, PFNGLCHECKFRAMEBUFFERSTATUSPROC)     \
  X(Clear, PFNGLCLEARPROC)                                       \
  X(ClearColor, PFNGLCLEARCOLORPROC)                             \
  X(CompileShader, PFNGLCOMPILESHADERPROC)                       \
  X(CreateProgram, PFNGLCREATEPROGRAMPROC)                       \
  X(CreateShader, PFNGLCREATESHADERPROC)                         \
  X(DeleteBuffers, PFNGLDELETEBUFFERSPROC)                       \
  X(DeleteFramebuffers, PFNGLDELETEFRAMEBUFFERSPROC)             \
  X(DeleteProgram, PFNGLDELETEPROGRAMPROC)                       \
  X(DeleteRenderbuffers, PFNGLDELETERENDERBUFFERSPROC)           \
  X(DeleteShader, PFNGLDELETESHADERPROC)                         \
  X(DeleteTextures, PFNGLDELETETEXTURESPROC)                     \
  X(Disable, PFNGLDISABLEPROC)                                   \
  X(DrawArrays, PFNGLDRAWARRAYSPROC)                             \
  X(DrawElements, PFNGLDRAWELEMENTSPROC)                         \
  X(Enable, PFNGLENABLEPROC)                                     \
  X(EnableVertexAttribArray, PFNGLENABLEVERTEXATTRIBARRAYPROC)   \
  X(Finish, PFNGLFINISHPROC)                                     \
  X(FramebufferRenderbuffer, PFNGLFRAMEBUFFERRENDERBUFFERPROC)   \
  X(FramebufferTexture2D, PFNGLFRAMEBUFFERTEXTURE2DPROC)         \
  X(GenBuffers, PFNGLGENBUFFERSPROC)                             \
  X(GenFramebuffers, PFNGLGENFRAMEBUFFERSPROC)                   \
  X(GenRenderbuffers, PFNGLGENRENDERBUFFERSPROC)                 \
  X(GenTextures, PFNGLGENTEXTURESPROC)                           \
  X(GetActiveUniform, PFNGLGETACTIVEUNIFORMPROC)                 \
  X(GetError, PFNGLGETERRORPROC)                                 \
  X(GetIntegerv, PFNGLGETINTEGERVPROC)                           \
  X(GetProgramInfoLog, PFNGLGETPROGRAMINFOLOGPROC)               \
  X(GetProgramiv, PFNGLGETPROGRAMIVPROC)                         \
  X(GetShaderInfoLog, PFNGLGETSHADERINFOLOGPROC)                 \
  X(GetShaderPrecisionFormat, PFNGLGETSHADERPRECISIONFORMATPROC) \
  X(GetShaderiv, PFNGLGETSHADERIVPROC)                           \
  X(GetString, PFNGLGETSTRINGPROC)                               \
  X(GetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC)             \
  X(LinkProgram, PFNGLLINKPROGRAMPROC)                           \
  X(PixelStorei, PFNGLPIXELSTOREIPROC)                           \
  X(ReadPixels, PFNGLREADPIXELSPROC)                             \
  X(RenderbufferStorage, PFNGLRENDERBUFFERSTORAGEPROC)           \
  X(Scissor, PFNGLSCISSORPROC)                                   \
  X(ShaderSource, PFNGLSHADERSOURCEPROC)                         \
  X(ClearStencil, PFNGLCLEARSTENCILPROC)                         \
  X(StencilFunc, PFNGLSTENCILFUNCPROC)                           \
  X(StencilOp, PFNGLSTENCILOPPROC)                               \
  X(TexImage2D, PFNGLTEXIMAGE2DPROC)                             \
  X(TexParameteri, PFNGLTEXPARAMETERIPROC)                       \
  X(Uniform1f, PFNGLUNIFORM1FPROC)                               \
  X(Uniform1i, PFNGLUNIFORM1IPROC)                               \
  X(Uniform2f, PFNGLUNIFORM2FPROC)                               \
  X(Uniform3f, PFNGLUNIFORM3FPROC)                               \
  X(Uniform4f, PFNGLUNIFORM4FPROC)                               \
  X(UseProgram, PFNGLUSEPROGRAMPROC)                             \
  X(VertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC)           \
  X(Viewport, PFNGLVIEWPORTPROC)

// Of ES 3.0: null where the context does not have it. A context of ES 2.0 may have it nonetheless.
#define GLIMT_GL_OPTIONAL_FUNCTIONS(X) X(DrawBuffers, PFNGLDRAWBUFFERSEXTPROC)

struct Functions {
#define GLIMT_GL_MEMBER(name, type) type name = nullptr;
  GLIMT_GL_FUNCTIONS(GLIMT_GL_MEMBER)
  GLIMT_GL_OPTIONAL_FUNCTIONS(GLIMT_GL_MEMBER)
#undef GLIMT_GL_MEMBER

  // Null where the context cannot tell whether a draw did anything; see Query.
  PFNGLGENQUERIESEXTPROC GenQueries = nullptr;
  PFNGLDELETEQUERIESEXTPROC DeleteQueries = nullptr;
  PFNGLBEGINQUERYEXTPROC BeginQuery = nullptr;
  PFNGLENDQUERYEXTPROC EndQuery = nullptr;
  PFNGLGETQUERYOBJECTUIVEXTPROC GetQueryObjectuiv = nullptr;

  // Null where the context cannot tell that it was lost; see Context.
  GLenum(GL_APIENTRYP GetGraphicsResetStatus)() = nullptr;

  // Errors: no_gl, naming the first function of ES 2.0 that the context does not have.
  static Functions load(const ProcLoader& loader);
};

}  // namespace glimt::gl
