#include "renderer/gl/stencil.h"

#include <fmt/format.h>

#include "renderer/gl/errors.h"

namespace glimt::gl {
namespace {

// Of GL_OES_packed_depth_stencil, ES 3.0 and desktop GL alike.
constexpr GLenum kDepth24Stencil8 = 0x88F0;

}  // namespace

Stencil::Stencil(const Functions& gl, StencilForm form, int width, int height) : form_(form) {
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  handle_ = RenderbufferHandle(gl, name);
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  clearErrors(gl);
  gl.RenderbufferStorage(GL_RENDERBUFFER,
                         form == StencilForm::alone ? GL_STENCIL_INDEX8 : kDepth24Stencil8, width,
                         height);
  checkErrors(gl, fmt::format("making a stencil of {} x {}", width, height));
}

void Stencil::attachTo(const Target& target) const {
  const Functions& gl = handle_.gl();
  target.bind();
  const auto attach = [&](GLenum attachment) {
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, handle_.name());
  };
  attach(GL_STENCIL_ATTACHMENT);
  if (form_ == StencilForm::with_depth) attach(GL_DEPTH_ATTACHMENT);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error(ErrorKind::failed, "a target of floats and a stencil do not go together");
}

std::optional<StencilForm> findStencilForm(const Functions& gl, FloatForm float_form) {
  std::optional<StencilForm> found;
  for (const StencilForm form : {StencilForm::alone, StencilForm::with_depth}) {
    try {
      const Target target(Texture::floats(gl, float_form, 4, 4));
      Stencil(gl, form, 4, 4).attachTo(target);
      found = form;
      break;
    } catch (const Error&) {  // this form is not for this context; the next one may be
    }
  }
  // A form that the context does not know leaves an error behind.
  clearErrors(gl);
  return found;
}

}  // namespace glimt::gl
