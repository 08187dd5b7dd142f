#include "renderer/bvh/octant_layout.h"

#include <algorithm>
#include <utility>

#include "shaders/layout.h"

namespace glimt {
namespace {

// Boxes are made larger by this much of a cell: more than what rounding does to a ray on the grid.
constexpr double kMargin = 0.01;

constexpr double kLastCell = NODE_GRID - 1;

// Over the whole scene, with a cell to spare on each side. A flat scene gets flat cells, but not
// ones without any thickness.
struct Grid {
  glm::dvec3 origin{0};
  glm::dvec3 cell{1};

  Grid() = default;
  explicit Grid(const Bounds& bounds) {
    const glm::dvec3 size(bounds.size());
    const double largest = std::max({size.x, size.y, size.z});
    if (!(largest > 0)) return;
    cell = Vec3(glm::max(size, glm::dvec3(1e-3 * largest)) / (kLastCell - 2));
    origin = Vec3(glm::dvec3(bounds.min) - cell);
  }

  Vec3 below(const Vec3& point) const { return clamped(glm::floor(place(point) - kMargin)); }
  Vec3 above(const Vec3& point) const { return clamped(glm::ceil(place(point) + kMargin)); }

 private:
  glm::dvec3 place(const Vec3& point) const { return (glm::dvec3(point) - origin) / cell; }
  static Vec3 clamped(const glm::dvec3& p) { return glm::clamp(p, 0.0, kLastCell); }
};

class OctantWriter {
 public:
  OctantWriter(const Bvh& bvh, const Grid& grid, unsigned octant, std::vector<Vec4>& texels)
      : bvh_(bvh), grid_(grid), octant_(octant), texels_(texels) {}

  void write() {
    if (!bvh_.nodes.empty()) writeNodes();
    const auto last = static_cast<float>(kLastCell);
    texels_.push_back(texel(Vec3(0), Vec3(last), 0.0f));
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
    return {enter + static_cast<float>(NODE_GRID) * leave, link};
  }

  const Bvh& bvh_;
  const Grid& grid_;
  unsigned octant_;
  std::vector<Vec4>& texels_;
};

}  // namespace

OctantLayout layOutOctants(const Bvh& bvh) {
  const Grid grid = bvh.nodes.empty() ? Grid() : Grid(bvh.nodes.front().bounds);
  OctantLayout layout;
  layout.grid_origin = Vec3(grid.origin);
  layout.grid_cell = Vec3(grid.cell);
  layout.nodes_per_octant = bvh.nodes.size() + 1;
  layout.texels.reserve(8 * layout.nodes_per_octant);
  for (unsigned octant = 0; octant < 8; ++octant)
    OctantWriter(bvh, grid, octant, layout.texels).write();
  return layout;
}

}  // namespace glimt
