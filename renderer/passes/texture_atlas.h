// All pictures of a scene's materials in one texture; read with shaders/texture_data.glsl.
#pragma once

#include <string>
#include <vector>

#include "renderer/gl/device.h"
#include "renderer/gl/program.h"
#include "renderer/passes/texture_packing.h"
#include "renderer/scene/scene.h"

namespace glimt {

class TextureAtlas {
 public:
  TextureAtlas() = default;

  // Of the pictures that the scene's materials look up. Errors: failed, when the device cannot make
  // it.
  TextureAtlas(const gl::Device& device, const Scene& scene);

  void bind(gl::Program& program) const;

  // Where each of Scene::images is.
  const std::vector<AtlasRectangle>& rectangles() const { return plan_.rectangles; }

  // What had to be made smaller.
  const std::vector<std::string>& warnings() const { return warnings_; }

  std::size_t bytes() const;

 private:
  AtlasPlan plan_;
  gl::Texture texture_;
  std::vector<std::string> warnings_;
};

}  // namespace glimt
