// A traversal alone: rays in from textures, hits out to a texture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/bench/bench_rays.h"
#include "renderer/gl/device.h"
#include "renderer/gl/program.h"
#include "renderer/passes/scene_textures.h"

namespace glimt {

// The rays on the device, and a target for what they meet.
class RayTextures {
 public:
  RayTextures(const gl::Device& device, const Rays& rays, int side);

  void bind(gl::Program& program) const;
  int side() const { return target_.width(); }
  const gl::Target& target() const { return target_; }

 private:
  gl::Texture origins_;
  gl::Texture directions_;
  gl::Target target_;
};

// Their side in the shader: rayOrigin() and rayDirection().
std::string rayTexturesText();

class TraversalProgram {
 public:
  enum class Question { closest_hit, visibility };

  // Errors: failed, for a shader that does not compile.
  TraversalProgram(const gl::Device& device, const std::string& traversal, Question question);

  // A whole fragment shader, which finds its rays with rayTexturesText().
  TraversalProgram(const gl::Device& device, const std::string& name, const std::string& shader,
                   int gles);

  // Casts all the rays and waits for them. Returns the seconds that took.
  double run(const SceneTextures& scene, const RayTextures& rays);

  // The seconds for which the program was compiled: some drivers leave most of that to the first
  // draw, so one pixel is drawn.
  double compileSeconds(const SceneTextures& scene, const RayTextures& rays);

 private:
  void prepare(const SceneTextures& scene, const RayTextures& rays);

  const gl::Device* device_;
  double compile_seconds_ = 0;  // up to the first draw
  std::optional<gl::Program> program_;
};

// What the last run left there. In `w` of each: for a closest hit its distance, -1 for a miss and
// -2 where the driver cut the traversal short; for visibility 1, 0, and negative where it was cut
// short. The rest is the unit normal of the triangle that was hit.
std::vector<Vec4> readResults(const RayTextures& rays);

}  // namespace glimt
