#include "renderer/bvh/octant_layout.h"

#include "shaders/layout.h"

namespace glimt {
namespace {

// Larger than any scene.
constexpr float kEverywhere = 1e30f;

Vec3 cornerOf(const Bounds& bounds, unsigned octant, bool enter) {
  Vec3 corner;
  for (int axis = 0; axis < 3; ++axis) {
    const bool negative = octant >> axis & 1u;
    corner[axis] = negative == enter ? bounds.max[axis] : bounds.min[axis];
  }
  return corner;
}

class OctantWriter {
 public:
  OctantWriter(const Bvh& bvh, unsigned octant, std::vector<Vec4>& texels)
      : bvh_(bvh), octant_(octant), texels_(texels) {}

  void write() {
    if (!bvh_.nodes.empty()) writeNodes();
    const Bounds everywhere{Vec3(-kEverywhere), Vec3(kEverywhere)};
    add(everywhere, -1.0f);
    link(texels_.size() - static_cast<std::size_t>(NODE_TEXELS), nodeCount() - 1);
  }

 private:
  // Depth first, with an explicit stack: a tree over equal boxes may be deep. A node is visited
  // again when its subtree has been written, to set its link.
  void writeNodes() {
    struct Visit {
      std::uint32_t node;
      std::size_t texel;  // where it was written
      bool done;
    };
    std::vector<Visit> stack{{0, 0, false}};
    while (!stack.empty()) {
      const Visit visit = stack.back();
      stack.pop_back();
      if (visit.done) {
        link(visit.texel, nodeCount());
        continue;
      }
      const BvhNode& node = bvh_.nodes[visit.node];
      const std::size_t texel = texels_.size();
      add(node.bounds, node.leaf() ? 1.0f + static_cast<float>(node.first) : 0.0f);
      stack.push_back({visit.node, texel, true});
      if (node.leaf()) continue;
      const std::uint32_t upper_first = octant_ >> node.axis & 1u;
      stack.push_back({node.first + 1 - upper_first, 0, false});
      stack.push_back({node.first + upper_first, 0, false});
    }
  }

  void add(const Bounds& bounds, float leaf) {
    texels_.emplace_back(cornerOf(bounds, octant_, true), 0.0f);
    texels_.emplace_back(cornerOf(bounds, octant_, false), leaf);
  }

  void link(std::size_t texel, std::size_t node) { texels_[texel].w = static_cast<float>(node); }

  std::size_t nodeCount() const { return texels_.size() / static_cast<std::size_t>(NODE_TEXELS); }

  const Bvh& bvh_;
  unsigned octant_;
  std::vector<Vec4>& texels_;
};

}  // namespace

OctantLayout layOutOctants(const Bvh& bvh) {
  OctantLayout layout;
  layout.nodes_per_octant = bvh.nodes.size() + 1;
  layout.texels.reserve(8 * layout.nodes_per_octant * static_cast<std::size_t>(NODE_TEXELS));
  for (unsigned octant = 0; octant < 8; ++octant)
    OctantWriter(bvh, octant, layout.texels).write();
  return layout;
}

}  // namespace glimt
