// What a traversal does for each ray, counted.
#pragma once

#include <vector>

#include "renderer/bench.h"
#include "renderer/bench/traversal_program.h"

namespace glimt {

// Casts the rays with the very shader text of the traversal, in which fetches and tests count
// themselves. One element for each ray, also for those that are not live. What lanes that run in
// lockstep wait for each other is not in it.
std::vector<RayWork> countRayWork(const gl::Device& device, const std::string& traversal,
                                  TraversalProgram::Question question, const SceneTextures& scene,
                                  const RayTextures& rays);

}  // namespace glimt
