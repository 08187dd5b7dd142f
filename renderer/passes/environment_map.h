// A picture of the environment as textures, and where in it the light comes from.
#pragma once

#include "renderer/core/effects.h"
#include "renderer/gl/device.h"
#include "renderer/gl/program.h"
#include "renderer/scene/scene.h"

namespace glimt {

// The picture's cells, one per pixel of a small one, and for each how often light samples go to it.
struct EnvironmentCells {
  int width = 0;
  int height = 0;
  // width * height texels, rows from the top: of an alias table (alias_table.h) the share of the
  // cell and the index of the other one; the density of samples in it, per solid angle.
  std::vector<Vec4> texels;
};

// In proportion to what a cell sends, bilinear lookups as in shaders/environment_map.glsl. `most`
// limits the number of cells; one is several pixels of a larger picture. Errors: input, for a
// picture that is black.
EnvironmentCells environmentCells(const Image& image, std::size_t most);

class EnvironmentMap {
 public:
  EnvironmentMap() = default;

  // Empty where the effects lack environment_map; where they have it, an even environment is a
  // picture of one pixel. Errors: input, for a picture larger than the device's textures.
  EnvironmentMap(const gl::Device& device, const Environment& environment,
                 const EffectSet& effects);

  // Takes the environment's rotation and how bright it is. Its picture is the one that this was
  // made of.
  void turn(const Environment& environment);

  void bind(gl::Program& program) const;
  std::size_t bytes() const;

 private:
  gl::Texture picture_;
  gl::Texture cells_;
  Vec3 scale_{1};
  Vec2 rotation_{1, 0};  // cosine, sine
};

}  // namespace glimt
