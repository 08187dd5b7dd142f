// Pictures beside the picture: what compositing, denoising and people who look for the cost ask
// for.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "renderer/core/image_layers.h"
#include "renderer/renderer.h"

namespace glimt {

// As the command line calls them.
inline constexpr std::array<const char*, 6> kLayerNames{"albedo",   "normal", "depth",
                                                        "material", "noise",  "cost"};

// What the renderer has to keep from the beginning for the layers that are wanted.
void keepFor(const std::vector<std::string>& wanted, RenderSettings& settings);

// The picture before it was denoised: undenoised.R .G .B.
void addUndenoised(ImageLayers& layers, const Image& picture);

// Adds them: albedo.R .G .B; normal.X .Y .Z; depth.Z; material; noise; cost. The picture is the
// renderer's. Errors: as Renderer::firstHits.
void addAuxiliaryLayers(ImageLayers& layers, const std::vector<std::string>& wanted,
                        const Picture& picture, Renderer& renderer);

}  // namespace glimt
