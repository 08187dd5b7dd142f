// The pictures that a material looks up.
#pragma once

#include <array>

#include "renderer/scene/scene.h"

namespace glimt {

// All of them, used or not, in the order of shaders/layout.h.
std::array<TextureUse*, 9> usesOf(Material& material);
std::array<const TextureUse*, 9> usesOf(const Material& material);

// Which of them are colours, sRGB-encoded.
inline constexpr std::array<bool, 9> kIsColor{true,  false, true, false, false,
                                              false, false, true, false};

// An unlit material as one that emits its base colour and reflects nothing; any other as it is.
Material shadedAs(const Material& material);

// Mean over a picture of colours, linear.
Vec3 meanOfColors(const TextureImage& image);

// Drops uses of pictures and of vertex attributes that the scene does not have, brings numbers into
// their ranges, and tells it in scene.warnings.
void checkTextures(Scene& scene);

}  // namespace glimt
