#include "renderer/bvh/node_grid.h"

#include <algorithm>

#include "shaders/layout.h"

namespace glimt {
namespace {

// Boxes are made larger by this much of a cell: more than what rounding does to a ray on the grid.
constexpr double kMargin = 0.01;

constexpr double kLastCell = NODE_GRID - 1;

Vec3 clamped(const glm::dvec3& p) {
  return glm::clamp(p, 0.0, kLastCell);
}

}  // namespace

NodeGrid::NodeGrid(const Bvh& bvh) {
  if (bvh.nodes.empty()) return;
  const Bounds& bounds = bvh.nodes.front().bounds;
  const glm::dvec3 size(bounds.size());
  const double largest = std::max({size.x, size.y, size.z});
  if (!(largest > 0)) return;
  cell_ = Vec3(glm::max(size, glm::dvec3(1e-3 * largest)) / (kLastCell - 2));
  origin_ = Vec3(glm::dvec3(bounds.min) - cell_);
}

Vec3 NodeGrid::below(const Vec3& point) const {
  return clamped(glm::floor(place(point) - kMargin));
}

Vec3 NodeGrid::above(const Vec3& point) const {
  return clamped(glm::ceil(place(point) + kMargin));
}

Vec3 NodeGrid::packed(const Vec3& first, const Vec3& second) {
  return first + static_cast<float>(NODE_GRID) * second;
}

}  // namespace glimt
