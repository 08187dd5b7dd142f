// The triangles of a glTF scene's meshes, wherever they stand.
#pragma once

#include <optional>
#include <vector>

#include "renderer/scene/gltf_node.h"
#include "renderer/scene/scene.h"

namespace glimt {

// Fills scene.origin, positions, normals, texcoords, colors and triangles. Their materials are the
// file's own, and behind them the one of primitives without. What has no surface is left out with a
// warning. Errors: input, also for more than the renderer can hold.
void readGltfMeshes(const GltfDocument& document, const std::vector<GltfInstance>& instances,
                    std::optional<std::size_t> variant, Scene& scene);

}  // namespace glimt
