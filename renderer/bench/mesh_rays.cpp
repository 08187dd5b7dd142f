#include "renderer/bench/mesh_rays.h"

#include "renderer/bench/traversal_program.h"

namespace glimt {

MeshRays makeMeshRays(const gl::Device& device, const Scene& scene, const SceneTextures& tree,
                      int side) {
  const Rays camera = makeCameraRays(scene.camera, side);
  const RayTextures textures(device, camera, side);
  TraversalProgram(device, "skip", TraversalProgram::Question::closest_hit).run(tree, textures);
  const std::vector<SurfaceHit> hits = readResults(textures);
  return {camera, makeBounceRays(camera, hits), makeShadowRays(camera, hits)};
}

}  // namespace glimt
