#include "renderer/passes/scene_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "renderer/bvh/node_layout.h"
#include "renderer/core/error.h"
#include "renderer/core/wording.h"
#include "renderer/passes/data_texture.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

// Eight copies of the tree pay while they fit: above this many triangles one copy is enough memory.
constexpr std::size_t kMostTrianglesForOctants = 500000;
constexpr std::size_t kOctants = 8;

std::vector<Bounds> boundsOf(const Scene& scene) {
  std::vector<Bounds> boxes;
  boxes.reserve(scene.triangles.size());
  for (const Triangle& triangle : scene.triangles) {
    Bounds box;
    for (const std::uint32_t index : triangle.positions) box.include(scene.positions[index]);
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace

// The hit record's 23 bits hold more.
std::size_t mostTriangles(int max_texture_size) {
  return mostTexels(max_texture_size) / static_cast<std::size_t>(TRIANGLE_TEXELS);
}

SceneTree buildSceneTree(const Scene& scene, int max_texture_size, const WorkProgress& progress) {
  const std::size_t most = mostTriangles(max_texture_size);
  if (scene.triangles.size() > most)
    throw Error(ErrorKind::input,
                fmt::format("the scene has {}, and {} fit into this device's textures; use a "
                            "smaller model",
                            counted(scene.triangles.size(), "triangle"), grouped(most)));
  const auto start = std::chrono::steady_clock::now();
  SceneTree tree{buildBvh(boundsOf(scene), 0, progress), 0};
  tree.build_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return tree;
}

bool isOver(const SceneTree& tree, const Scene& scene) {
  const Bvh& bvh = tree.bvh;
  if (bvh.order.size() != scene.triangles.size()) return false;
  const std::vector<Bounds> boxes = boundsOf(scene);
  return std::all_of(bvh.nodes.begin(), bvh.nodes.end(), [&](const BvhNode& node) {
    if (!node.leaf()) return true;
    Bounds box;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      box.include(boxes[bvh.order[i]]);
    return box.min == node.bounds.min && box.max == node.bounds.max;
  });
}

void checkFits(const Traversal& traversal, std::size_t stack_size) {
  if (stack_size > traversal.most_levels)
    throw Error(ErrorKind::input,
                fmt::format("the scene's tree is {} levels deep, and traversal '{}' holds {}; use "
                            "--traversal skip",
                            stack_size, traversal.name, traversal.most_levels));
}

void checkRuns(const Traversal& traversal, const ContextInfo& context) {
  if (traversal.gles > context.gles)
    throw Error(ErrorKind::usage,
                fmt::format("traversal '{}' needs OpenGL ES {}.0; render with --gles {}, or choose "
                            "another traversal",
                            traversal.name, traversal.gles, traversal.gles));
}

std::vector<std::string> candidateTraversals(const std::string& asked, const Bvh& bvh,
                                             const ContextInfo& context, std::size_t most_texels) {
  if (asked != "auto") {
    checkRuns(traversalNamed(asked), context);
    checkFits(traversalNamed(asked), stackSizeOf(bvh));
    return {asked};
  }
  const std::size_t octant_texels = kOctants * (bvh.nodes.size() + 1);
  if (bvh.order.size() <= kMostTrianglesForOctants && octant_texels <= most_texels)
    return context.software ? std::vector<std::string>{"octant-ahead", "octant"}
                            : std::vector<std::string>{"octant", "octant-ahead"};
  return {stackSizeOf(bvh) <= STACK_SIZE ? "stack" : "skip"};
}

}  // namespace glimt
