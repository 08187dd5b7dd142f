// The tree over a scene's triangles, and the traversal that suits it.
#pragma once

#include <string>
#include <vector>

#include "renderer/bvh/bvh.h"
#include "renderer/core/context_info.h"
#include "renderer/scene/scene.h"
#include "renderer/shader/traversals.h"

namespace glimt {

struct SceneTree {
  Bvh bvh;  // its primitives are Scene::triangles
  double build_seconds = 0;
};

// How many triangles fit into a texture on a device with textures of up to `max_texture_size` a
// side.
std::size_t mostTriangles(int max_texture_size);

// Errors: input, for more triangles than that.
SceneTree buildSceneTree(const Scene& scene, int max_texture_size,
                         const WorkProgress& progress = {});

// Whether the tree is one over the scene's triangles: they are as many, and each leaf bounds those
// that it holds.
bool isOver(const SceneTree& tree, const Scene& scene);

// Errors: input, where the tree is deeper than the traversal can hold.
void checkFits(const Traversal& traversal, std::size_t stack_size);

// Errors: usage, where the traversal needs a later OpenGL ES than the context's.
void checkRuns(const Traversal& traversal, const ContextInfo& context);

// `asked` itself, or for "auto" those that may be the fastest, the likeliest first, as measured in
// docs/performance.md. They share one layout of the tree, hold it, and run on any context. While
// eight copies of the tree are small and fit into a texture of `most_texels` these are the octants,
// with two nodes a step first where the device is a CPU, else with one. Above, it is the stack
// while it is deep enough, else skip. Errors: usage, for a traversal that does not exist or does
// not run on the context; input, for one that does not hold the tree.
std::vector<std::string> candidateTraversals(const std::string& asked, const Bvh& bvh,
                                             const ContextInfo& context, std::size_t most_texels);

}  // namespace glimt
