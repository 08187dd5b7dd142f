#include "renderer/passes/scene_tree.h"

#include <fmt/format.h>

#include <chrono>

#include "renderer/bvh/node_layout.h"
#include "renderer/core/error.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

// More do not fit into a texture; see data_texture.cpp. The hit record's 23 bits would hold them.
constexpr std::size_t kMaxTriangles =
    (std::size_t{1} << 23) / static_cast<std::size_t>(TRIANGLE_TEXELS);

// Eight copies of the tree pay while they fit: above this many triangles one copy is enough memory.
constexpr std::size_t kMostTrianglesForOctants = 500000;

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

SceneTree buildSceneTree(const Scene& scene) {
  if (scene.triangles.size() > kMaxTriangles)
    throw Error(ErrorKind::input, fmt::format("the scene has {} triangles, and {} is the most that "
                                              "can be rendered; use a smaller model",
                                              scene.triangles.size(), kMaxTriangles));
  const auto start = std::chrono::steady_clock::now();
  SceneTree tree{buildBvh(boundsOf(scene)), 0};
  tree.build_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return tree;
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

std::string chooseTraversal(const std::string& asked, const Bvh& bvh, const ContextInfo& context) {
  if (asked != "auto") {
    checkRuns(traversalNamed(asked), context);
    checkFits(traversalNamed(asked), stackSizeOf(bvh));
    return asked;
  }
  if (bvh.order.size() <= kMostTrianglesForOctants)
    return context.software ? "octant-ahead" : "octant";
  return stackSizeOf(bvh) <= STACK_SIZE ? "stack" : "skip";
}

}  // namespace glimt
