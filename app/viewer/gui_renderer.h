// Draws what Dear ImGui asks for with OpenGL ES 2.0.
#pragma once

#include <imgui.h>

#include <array>

#include "renderer/core/image.h"
#include "renderer/gl/program.h"

namespace glimt {

// A picture on the GPU, smoothly scaled where it is drawn in another size.
class GuiTexture {
 public:
  GuiTexture() = default;
  explicit GuiTexture(const gl::Functions& gl);

  void set(const DisplayImage& image);
  // Four bytes a pixel, rows from the top.
  void set(int width, int height, const unsigned char* rgba);

  ImTextureID id() const;
  bool empty() const { return width_ == 0; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  void upload(GLenum form, int width, int height, const void* pixels);

  gl::TextureHandle handle_;
  int width_ = 0;
  int height_ = 0;
};

class GuiRenderer {
 public:
  // Takes the fonts of the current ImGui context. Errors: failed, as gl::Program.
  explicit GuiRenderer(const gl::Functions& gl);

  void draw(const ImDrawData& data);

 private:
  void prepare(const ImDrawData& data);
  void drawList(const ImDrawData& data, const ImDrawList& list);

  const gl::Functions& gl_;
  gl::Program program_;
  gl::BufferHandle vertices_;
  gl::BufferHandle indices_;
  GuiTexture fonts_;
};

}  // namespace glimt
