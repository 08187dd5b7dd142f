#include "app/viewer/gui_renderer.h"

#include <algorithm>
#include <cstddef>

namespace glimt {
namespace {

constexpr const char* kVertexShader = R"(#version 100
attribute vec2 position;
attribute vec2 texcoord;
attribute vec4 color;
uniform vec4 uView;  // scale and offset from pixels to the window's
varying vec2 vTexcoord;
varying vec4 vColor;
void main() {
  vTexcoord = texcoord;
  vColor = color;
  gl_Position = vec4(position * uView.xy + uView.zw, 0.0, 1.0);
}
)";

constexpr const char* kFragmentShader = R"(#version 100
precision mediump float;
uniform sampler2D uTexture;
varying vec2 vTexcoord;
varying vec4 vColor;
void main() {
  gl_FragColor = vColor * texture2D(uTexture, vTexcoord);
}
)";

gl::BufferHandle makeBuffer(const gl::Functions& gl) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  return {gl, name};
}

const void* at(std::size_t offset) {
  return reinterpret_cast<const void*>(offset);
}

}  // namespace

GuiTexture::GuiTexture(const gl::Functions& gl) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  handle_ = gl::TextureHandle(gl, name);
}

void GuiTexture::set(const DisplayImage& image) {
  upload(GL_RGB, image.width, image.height, image.bytes.data());
}

void GuiTexture::set(int width, int height, const unsigned char* rgba) {
  upload(GL_RGBA, width, height, rgba);
}

void GuiTexture::upload(GLenum form, int width, int height, const void* pixels) {
  const gl::Functions& gl = handle_.gl();
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, handle_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(form), width, height, 0, form,
                GL_UNSIGNED_BYTE, pixels);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  width_ = width;
  height_ = height;
}

ImTextureID GuiTexture::id() const {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(handle_.name()));
}

GuiRenderer::GuiRenderer(const gl::Functions& gl)
    : gl_(gl),
      program_(gl, "the user interface", kVertexShader, kFragmentShader),
      vertices_(makeBuffer(gl)),
      indices_(makeBuffer(gl)),
      fonts_(gl) {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  fonts_.set(width, height, pixels);
  io.Fonts->SetTexID(fonts_.id());
}

void GuiRenderer::prepare(const ImDrawData& data) {
  const ImVec2 size = data.DisplaySize;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.Viewport(0, 0, static_cast<GLsizei>(size.x * data.FramebufferScale.x),
               static_cast<GLsizei>(size.y * data.FramebufferScale.y));
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  program_.use();
  program_.set("uView", Vec4(2 / size.x, -2 / size.y, -1, 1));
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  for (const GLuint attribute : {0u, 1u, 2u}) gl_.EnableVertexAttribArray(attribute);
  constexpr auto kStride = static_cast<GLsizei>(sizeof(ImDrawVert));
  gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride, at(offsetof(ImDrawVert, pos)));
  gl_.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride, at(offsetof(ImDrawVert, uv)));
  gl_.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, at(offsetof(ImDrawVert, col)));
}

void GuiRenderer::drawList(const ImDrawData& data, const ImDrawList& list) {
  gl_.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data,
                 GL_STREAM_DRAW);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                 GL_STREAM_DRAW);
  static_assert(sizeof(ImDrawIdx) == 2);
  const ImVec2 scale = data.FramebufferScale;
  const float height = data.DisplaySize.y * scale.y;
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const ImVec4 clip = command.ClipRect;
    const float left = std::max(clip.x * scale.x, 0.0f);
    const float top = std::max(clip.y * scale.y, 0.0f);
    const float right = clip.z * scale.x;
    const float bottom = std::min(clip.w * scale.y, height);
    if (right <= left || bottom <= top || command.ElemCount == 0) continue;
    gl_.Scissor(static_cast<GLint>(left), static_cast<GLint>(height - bottom),
                static_cast<GLsizei>(right - left), static_cast<GLsizei>(bottom - top));
    gl_.BindTexture(GL_TEXTURE_2D,
                    static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
    gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), GL_UNSIGNED_SHORT,
                     at(command.IdxOffset * sizeof(ImDrawIdx)));
  }
}

void GuiRenderer::draw(const ImDrawData& data) {
  if (data.DisplaySize.x <= 0 || data.DisplaySize.y <= 0) return;
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.ClearColor(0.11f, 0.11f, 0.12f, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  prepare(data);
  for (int i = 0; i < data.CmdListsCount; ++i) drawList(data, *data.CmdLists[i]);
}

}  // namespace glimt
