// KHR_draco_mesh_compression: the vertices and triangles of a primitive, packed.
#pragma once

#include <string>

#include "renderer/scene/gltf_primitive.h"

namespace glimt {

bool isDraco(const tinygltf::Primitive& primitive);

// Errors: input, for what Draco cannot unpack, and for attributes that are not in it.
GltfGeometry readDracoPrimitive(const GltfDocument& document, const tinygltf::Primitive& primitive,
                                const std::string& who);

}  // namespace glimt
