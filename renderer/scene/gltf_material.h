// The materials of a glTF file, in the renderer's terms.
#pragma once

#include "renderer/scene/gltf_document.h"
#include "renderer/scene/scene.h"

namespace glimt {

// Appends all of the file's materials to scene.materials in their order, and behind them the one of
// primitives that name none; what they look up goes into scene.images, and what is left out is
// told in scene.warnings. Errors: input.
void readGltfMaterials(const GltfDocument& document, Scene& scene);

}  // namespace glimt
