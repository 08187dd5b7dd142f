#include "assets/generate/model/studio_set.h"

#include <cmath>

#include "assets/generate/geometry/grid.h"

namespace glimt::assets {

Mesh sweptBackdrop(const BackdropSize& size) {
  constexpr int kSteps = 24;
  return grid(1, kSteps + 2, Edges::open, Edges::open, [&](int i, int j) {
    const double x = i == 0 ? -size.half_width : size.half_width;
    if (j == 0) return dvec3(x, 0, size.front);
    if (j == kSteps + 2) return dvec3(x, size.top, size.bend - size.radius);
    const double angle = glm::radians(90.0 * (j - 1) / kSteps);
    return dvec3(x, size.radius * (1 - std::cos(angle)), size.bend - size.radius * std::sin(angle));
  });
}

Mesh softBox(const dvec3& at, const dvec3& target, double width, double height) {
  const dvec3 forward = glm::normalize(target - at);
  const dvec3 up = std::abs(forward.y) > 0.9 ? dvec3(0, 0, -1) : dvec3(0, 1, 0);
  const dvec3 right = glm::normalize(glm::cross(up, forward)) * (0.5 * width);
  const dvec3 above = glm::normalize(glm::cross(forward, right)) * (0.5 * height);
  return grid(1, 1, Edges::open, Edges::open,
              [&](int i, int j) { return at + (2.0 * i - 1) * right + (2.0 * j - 1) * above; });
}

void addSoftBox(Model& model, const std::string& name, const dvec3& radiance, const Mesh& box) {
  Material light;
  light.base_color = dvec3(0);
  light.roughness = 1;
  light.emission = radiance;
  model.materials[name] = light;
  model.add(name, name, box);
}

}  // namespace glimt::assets
