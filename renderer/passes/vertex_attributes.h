// Texture coordinates and colours of vertices as shaders/layout.h lays them out.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/core/effects.h"
#include "renderer/scene/scene.h"

namespace glimt {

// For each triangle, in the order of `order`, into Scene::triangles. Nothing where the effects
// lack both textures and vertex_colors. Triangles without coordinates have zeros, without colours
// white.
std::vector<Vec4> packAttributes(const Scene& scene, const std::vector<std::uint32_t>& order,
                                 const EffectSet& effects);

}  // namespace glimt
