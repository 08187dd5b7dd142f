// Whole paths in one shader, for comparison with the renderer's one pass per bounce.
#pragma once

#include <optional>
#include <vector>

#include "renderer/gl/device.h"
#include "renderer/gl/program.h"
#include "renderer/passes/accumulation.h"
#include "renderer/passes/path_tracer.h"

namespace glimt {

enum class PathForm {
  loop,      // over the bounces
  unrolled,  // the bounces written out one after the other
};

// Draws the picture that a PathTracer with the same settings draws, with the same sample points.
class WholePathTracer {
 public:
  // `textures` are the scene's, in the layout of settings.traversal, which is one of traversals();
  // they outlive this. Errors: failed, for a shader that the driver refuses.
  WholePathTracer(const gl::Device& device, const Scene& scene, const SceneTextures& textures,
                  const PathTracerSettings& settings, PathForm form);

  // Forgets all samples.
  void resize(int width, int height);

  void drawSample();

  // Of the last sample.
  std::vector<Vec4> readRadiance() const { return radiance_.readFloats(); }

 private:
  void use(gl::Program& program) const;
  void bindSamplePoints();
  void drawPaths();

  const gl::Device* device_;
  const SceneTextures* textures_;
  int surfaces_;
  SamplePoints points_;
  gl::Texture offsets_;
  Camera camera_;
  gl::Program paths_;
  gl::Target radiance_;
  Accumulation accumulation_;
  std::uint32_t samples_ = 0;
};

}  // namespace glimt
