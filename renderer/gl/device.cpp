#include "renderer/gl/device.h"

#include <array>

#include "renderer/gl/errors.h"
#include "renderer/gl/float_target.h"

namespace glimt::gl {
namespace {

FloatForm requireFloatForm(const Functions& gl) {
  const auto form = findFloatForm(gl, {FloatForm::sized, FloatForm::unsized});
  if (form) return *form;
  checkErrors(gl, "trying float targets", ErrorKind::no_gl);
  throw Error(ErrorKind::no_gl,
              "the context cannot draw into textures of 32-bit floats (RGBA32F); try another "
              "driver or --backend");
}

// One triangle that covers the viewport.
BufferHandle makeTriangle(const Functions& gl) {
  constexpr std::array<float, 6> kCorners{-1, -1, 3, -1, -1, 3};
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  BufferHandle buffer(gl, name);
  gl.BindBuffer(GL_ARRAY_BUFFER, name);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(kCorners), kCorners.data(), GL_STATIC_DRAW);
  return buffer;
}

}  // namespace

Device::Device(Context& context)
    : gl_(&context.functions()),
      info_(context.info()),
      float_form_(requireFloatForm(*gl_)),
      stencil_form_(findStencilForm(*gl_, float_form_)),
      triangle_(makeTriangle(*gl_)) {
  gl_->GetIntegerv(GL_MAX_TEXTURE_SIZE, &max_texture_size_);
  // Desktop GL blends whatever it can draw to; ES wants an extension for 32-bit floats.
  const bool es = info_.version.find("OpenGL ES") != std::string::npos;
  float_blending_ = !es || context.hasExtension("GL_EXT_float_blend");
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_->BlendFunc(GL_ONE, GL_ONE);
  checkErrors(*gl_, "preparing to draw", ErrorKind::no_gl);
}

void Device::draw(const Tile& tile, const DrawState& state) const {
  gl_->Enable(GL_SCISSOR_TEST);
  gl_->Scissor(tile.x, tile.y, tile.width, tile.height);
  if (state.adding) gl_->Enable(GL_BLEND);
  if (state.limit != Limit::none) {
    gl_->Enable(GL_STENCIL_TEST);
    gl_->StencilFunc(GL_EQUAL, 0, 255);
    gl_->StencilOp(GL_KEEP, GL_KEEP, state.limit == Limit::unmarked ? GL_KEEP : GL_INCR);
  }
  drawTriangle();
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_STENCIL_TEST);
}

void Device::drawTriangle() const {
  gl_->BindBuffer(GL_ARRAY_BUFFER, triangle_.name());
  gl_->EnableVertexAttribArray(0);
  gl_->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace glimt::gl
