#include "renderer/scene/gltf_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/core/wording.h"
#include "renderer/scene/gltf_extensions.h"
#include "renderer/scene/gltf_transform.h"

namespace glimt {
namespace {

// Each takes a matrix; together with the scene below 2 GiB of memory.
constexpr std::size_t kMostInstances = 1 << 20;

bool isFinite(const glm::dmat4& matrix) {
  const double* const numbers = glm::value_ptr(matrix);
  for (int i = 0; i < 16; ++i)
    if (!std::isfinite(numbers[i])) return false;
  return true;
}

class NodeWalk {
 public:
  explicit NodeWalk(const GltfDocument& document)
      : document_(document), nodes_(document.model.nodes), has_parent_(nodes_.size()) {
    for (const tinygltf::Node& node : nodes_)
      for (const int child : node.children) {
        if (has_parent_[inRange(child)])
          document_.fail(fmt::format("node {} has two parents; export the model again", child));
        has_parent_[inRange(child)] = true;
      }
    demandNoCycle();
  }

  GltfInstances instances() {
    std::vector<bool> seen(nodes_.size());
    for (const int root : sceneRoots()) {
      walkFrom(root, [&](std::size_t node, const glm::dmat4& to_world) {
        if (seen[node])
          document_.fail(
              fmt::format("node {} is in the scene twice; export the model again", node));
        seen[node] = true;
        place(node, to_world);
      });
    }
    return std::move(instances_);
  }

 private:
  std::size_t inRange(int node) const {
    if (node < 0 || static_cast<std::size_t>(node) >= nodes_.size())
      document_.fail(
          fmt::format("a node or scene names node {}, but the file has {}; export the "
                      "model again",
                      node, nodes_.size()));
    return static_cast<std::size_t>(node);
  }

  std::vector<int> allRoots() const {
    std::vector<int> roots;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (!has_parent_[i]) roots.push_back(static_cast<int>(i));
    return roots;
  }

  std::vector<int> sceneRoots() const {
    const auto& scenes = document_.model.scenes;
    if (scenes.empty()) return allRoots();
    const int scene = document_.model.defaultScene;
    if (scene >= 0 && static_cast<std::size_t>(scene) >= scenes.size())
      document_.fail(
          fmt::format("the default scene is {}, but the file has {}; export the model "
                      "again",
                      scene, scenes.size()));
    return scenes[static_cast<std::size_t>(std::max(scene, 0))].nodes;
  }

  // By a stack of its own: files may nest as deep as they like.
  template <typename Visit>
  void walkFrom(int root, Visit&& visit) const {
    struct Waiting {
      std::size_t node;
      glm::dmat4 parent_to_world;
    };
    std::vector<Waiting> waiting = {{inRange(root), glm::dmat4(1)}};
    while (!waiting.empty()) {
      const Waiting next = waiting.back();
      waiting.pop_back();
      const tinygltf::Node& node = nodes_[next.node];
      const glm::dmat4 to_world = next.parent_to_world * transformOf(document_, node);
      visit(next.node, to_world);
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
        waiting.push_back({inRange(*child), to_world});
    }
  }

  // With one parent each, what no root leads to goes round.
  void demandNoCycle() const {
    std::size_t reached = 0;
    for (const int root : allRoots())
      walkFrom(root, [&](std::size_t, const glm::dmat4&) { ++reached; });
    if (reached != nodes_.size())
      document_.fail("nodes are their own ancestors; export the model again");
  }

  void add(std::vector<GltfInstance>& list, int index, std::size_t count, std::size_t node,
           const glm::dmat4& to_world, const char* what) {
    if (index < 0 || static_cast<std::size_t>(index) >= count)
      document_.fail(fmt::format("node {} has {} {}, but the file has {}; export the model again",
                                 node, what, index, count));
    if (!isFinite(to_world))
      document_.fail(
          fmt::format("the transform of node {} is not finite; export the model again", node));
    if (list.size() >= kMostInstances)
      document_.fail(fmt::format("more than {} instances of meshes; use a smaller model",
                                 grouped(kMostInstances)));
    list.push_back({static_cast<std::size_t>(index), node, to_world});
  }

  void place(std::size_t index, const glm::dmat4& to_world) {
    const tinygltf::Node& node = nodes_[index];
    const tinygltf::Model& model = document_.model;
    if (node.mesh != -1) {
      const std::vector<glm::dmat4> repeats = repeatsOf(document_, node);
      for (const glm::dmat4& repeat : repeats)
        add(instances_.meshes, node.mesh, model.meshes.size(), index, to_world * repeat, "mesh");
      if (repeats.empty())
        add(instances_.meshes, node.mesh, model.meshes.size(), index, to_world, "mesh");
    }
    if (node.camera != -1)
      add(instances_.cameras, node.camera, model.cameras.size(), index, to_world, "camera");
    if (const auto* extension = extensionOf(node.extensions, "KHR_lights_punctual"))
      add(instances_.lights, indexOf(*extension, "light").value_or(-1), model.lights.size(), index,
          to_world, "light");
  }

  const GltfDocument& document_;
  const std::vector<tinygltf::Node>& nodes_;
  std::vector<bool> has_parent_;
  GltfInstances instances_;
};

}  // namespace

GltfInstances instancesOf(const GltfDocument& document) {
  return NodeWalk(document).instances();
}

}  // namespace glimt
