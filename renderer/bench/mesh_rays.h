// All the rays that a mesh of the bench is measured with.
#pragma once

#include <array>

#include "renderer/bench.h"
#include "renderer/bench/bench_rays.h"
#include "renderer/gl/device.h"
#include "renderer/passes/scene_textures.h"

namespace glimt {

inline constexpr std::size_t kShadowRays =
    2;  // in kRayKinds, the only kind that asks for visibility

using MeshRays = std::array<Rays, kRayKinds.size()>;

// side * side of each kind. The camera's hits, from which the others start, are those of traversal
// "skip", since it takes any tree: `tree` has its layout.
MeshRays makeMeshRays(const gl::Device& device, const Scene& scene, const SceneTextures& tree,
                      int side);

}  // namespace glimt
