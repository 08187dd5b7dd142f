// Materials as shaders/layout.h lays them out.
#pragma once

#include <vector>

#include "renderer/passes/light_table.h"
#include "renderer/passes/texture_atlas.h"
#include "renderer/scene/scene.h"

namespace glimt {

// MATERIAL_TEXELS for each of the scene's materials.
std::vector<Vec4> packMaterials(const Scene& scene, const LightTable& lights,
                                const TextureAtlas& atlas);

}  // namespace glimt
