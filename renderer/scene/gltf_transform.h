// The transform of a glTF node, from its own space to its parent's.
#pragma once

#include <vector>

#include "renderer/core/vector.h"
#include "renderer/scene/gltf_document.h"

namespace glimt {

// Errors: input, where the node's numbers are too few or many.
glm::dmat4 transformOf(const GltfDocument& document, const tinygltf::Node& node);

// Of EXT_mesh_gpu_instancing, to the node's space; empty where the node has none. Errors: input.
std::vector<glm::dmat4> repeatsOf(const GltfDocument& document, const tinygltf::Node& node);

}  // namespace glimt
