// The nodes of a glTF scene: what stands where.
#pragma once

#include <vector>

#include "renderer/core/vector.h"
#include "renderer/scene/gltf_document.h"

namespace glimt {

// A node's mesh, camera or light, and its place.
struct GltfInstance {
  std::size_t index;    // into the model's meshes, cameras or lights
  std::size_t node;     // into the model's nodes
  glm::dmat4 to_world;  // finite
};

struct GltfInstances {
  std::vector<GltfInstance> meshes;
  std::vector<GltfInstance> cameras;
  std::vector<GltfInstance> lights;
};

// Of the default scene, else the first one, else all nodes. What EXT_mesh_gpu_instancing repeats is
// in it as often. Errors: input, for nodes that are not there, have two parents or are their own
// ancestors, and for transforms that are not finite.
GltfInstances instancesOf(const GltfDocument& document);

}  // namespace glimt
