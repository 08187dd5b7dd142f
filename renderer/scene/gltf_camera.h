// The cameras of a glTF scene.
#pragma once

#include <string>
#include <vector>

#include "renderer/core/bounds.h"
#include "renderer/scene/gltf_node.h"
#include "renderer/scene/scene.h"

namespace glimt {

// One for each node that has a camera, named after the node, else the camera. Each looks at a point
// beside the middle of `bounds`, the model's box in the scene's coordinates, so that it can be
// turned about it. What cannot be looked through is left out with a warning. `origin` is the
// scene's.
std::vector<NamedCamera> camerasOf(const GltfDocument& document,
                                   const std::vector<GltfInstance>& instances, const Bounds& bounds,
                                   const glm::dvec3& origin, std::vector<std::string>& warnings);

}  // namespace glimt
