// The production traversal, asked for single rays.
#pragma once

#include <string>
#include <vector>

#include "renderer/passes/scene_textures.h"
#include "tests/gpu/probe.h"

namespace glimt::test {

// What the first number of a closest hit is.
inline constexpr float kHit = 1;
inline constexpr float kMiss = 0;
inline constexpr float kUnknown = -1;

// Of rays given by origin and direction: hit or miss, material, distance, weight of vertex 1.
extern const std::string kClosestHit;

// The same as visibility() in the traversal.
extern const std::string kVisibility;

class TraversalProbe {
 public:
  // `text` is one of the above.
  TraversalProbe(const gl::Device& device, const std::string& text,
                 const std::string& traversal = traversals().front().name);

  std::vector<Vec4> run(const SceneTextures& scene, const std::vector<std::vector<Vec4>>& rays,
                        int width = 4096) {
    return probe_.run(
        rays, [&](gl::Program& program) { scene.bind(program); }, width);
  }

 private:
  Probe probe_;
};

}  // namespace glimt::test
