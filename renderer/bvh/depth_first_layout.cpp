#include <utility>

#include "renderer/bvh/node_grid.h"
#include "renderer/bvh/node_layout.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

class DepthFirstWriter {
 public:
  DepthFirstWriter(const Bvh& bvh, const NodeGrid& grid, unsigned octant, std::vector<Vec4>& texels)
      : bvh_(bvh), grid_(grid), octant_(octant), texels_(texels) {}

  void write() {
    if (!bvh_.nodes.empty()) writeNodes();
    texels_.push_back(texel(Vec3(0), Vec3(static_cast<float>(NODE_GRID - 1)), 0.0f));
  }

 private:
  // Depth first, with an explicit stack: a tree over equal boxes may be deep. An inner node is
  // visited again when its subtree has been written, to set its link.
  void writeNodes() {
    struct Visit {
      std::uint32_t node;
      std::size_t texel;  // where it was written, if it was
      bool done;
    };
    std::vector<Visit> stack{{0, 0, false}};
    while (!stack.empty()) {
      const Visit visit = stack.back();
      stack.pop_back();
      if (visit.done) {
        texels_[visit.texel].w = static_cast<float>(texels_.size());
        continue;
      }
      const BvhNode& node = bvh_.nodes[visit.node];
      const float link = node.leaf() ? -1.0f - static_cast<float>(node.first) : 0.0f;
      texels_.push_back(texel(grid_.below(node.bounds.min), grid_.above(node.bounds.max), link));
      if (node.leaf()) continue;
      stack.push_back({visit.node, texels_.size() - 1, true});
      const std::uint32_t upper_first = octant_ >> node.axis & 1u;
      stack.push_back({node.first + 1 - upper_first, 0, false});
      stack.push_back({node.first + upper_first, 0, false});
    }
  }

  // Bit `axis` of the octant says that the direction is negative there.
  Vec4 texel(Vec3 enter, Vec3 leave, float link) const {
    for (int axis = 0; axis < 3; ++axis)
      if (octant_ >> axis & 1u) std::swap(enter[axis], leave[axis]);
    return {NodeGrid::packed(enter, leave), link};
  }

  const Bvh& bvh_;
  const NodeGrid& grid_;
  unsigned octant_;
  std::vector<Vec4>& texels_;
};

NodeLayout layOutCopies(const Bvh& bvh, unsigned copies) {
  const NodeGrid grid(bvh);
  NodeLayout layout{{}, bvh.nodes.size() + 1, grid.origin(), grid.cell()};
  layout.texels.reserve(copies * layout.nodes_per_copy);
  for (unsigned octant = 0; octant < copies; ++octant)
    DepthFirstWriter(bvh, grid, octant, layout.texels).write();
  return layout;
}

}  // namespace

NodeLayout layOutOctants(const Bvh& bvh) {
  return layOutCopies(bvh, 8);
}

NodeLayout layOutOnce(const Bvh& bvh) {
  return layOutCopies(bvh, 1);
}

}  // namespace glimt
