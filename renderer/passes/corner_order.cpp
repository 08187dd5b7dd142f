#include "renderer/passes/corner_order.h"

#include <algorithm>

namespace glimt {
namespace {

// A cross product this much smaller than the product of its edges has lost four bits.
constexpr double kSliver = 1.0 / 16;

}  // namespace

std::array<std::size_t, 3> cornerOrder(const Scene& scene, const Triangle& triangle) {
  std::array<glm::dvec3, 3> corner;
  for (std::size_t i = 0; i < 3; ++i) corner[i] = scene.positions[triangle.positions[i]];
  const glm::dvec3 a = corner[1] - corner[0];
  const glm::dvec3 b = corner[2] - corner[0];
  if (glm::length(glm::cross(a, b)) > kSliver * glm::length(a) * glm::length(b)) return {0, 1, 2};
  std::array<double, 3> across;
  for (std::size_t i = 0; i < 3; ++i)
    across[i] = glm::distance(corner[(i + 1) % 3], corner[(i + 2) % 3]);
  const auto first =
      static_cast<std::size_t>(std::max_element(across.begin(), across.end()) - across.begin());
  return {first, (first + 1) % 3, (first + 2) % 3};
}

}  // namespace glimt
