#include <cmath>

#include "assets/generate/geometry/grid.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

// Floor, a quarter of a cylinder, wall.
Mesh backdrop() {
  constexpr double kHalfWidth = 9, kFront = 9, kBend = -1.3, kRadius = 2.4, kTop = 6;
  constexpr int kSteps = 24;
  Mesh mesh = grid(1, kSteps + 2, Edges::open, Edges::open, [&](int i, int j) {
    const double x = i == 0 ? -kHalfWidth : kHalfWidth;
    if (j == 0) return dvec3(x, 0, kFront);
    if (j == kSteps + 2) return dvec3(x, kTop, kBend - kRadius);
    const double angle = glm::radians(90.0 * (j - 1) / kSteps);
    return dvec3(x, kRadius * (1 - std::cos(angle)), kBend - kRadius * std::sin(angle));
  });
  return mesh;
}

// A soft box at `at` whose front looks at `target`.
Mesh softBox(const dvec3& at, const dvec3& target, double width, double height) {
  const dvec3 forward = glm::normalize(target - at);
  const dvec3 up = std::abs(forward.y) > 0.9 ? dvec3(0, 0, -1) : dvec3(0, 1, 0);
  const dvec3 right = glm::normalize(glm::cross(up, forward)) * (0.5 * width);
  const dvec3 above = glm::normalize(glm::cross(forward, right)) * (0.5 * height);
  return grid(1, 1, Edges::open, Edges::open,
              [&](int i, int j) { return at + (2.0 * i - 1) * right + (2.0 * j - 1) * above; });
}

void addLight(Model& model, const std::string& name, const dvec3& radiance, const Mesh& mesh) {
  Material light;
  light.base_color = dvec3(0);
  light.roughness = 1;
  light.emission = radiance;
  model.materials[name] = light;
  model.add(name, name, mesh);
}

}  // namespace

void addStudio(Model& model) {
  Material paper;
  paper.base_color = {0.50, 0.50, 0.505};
  paper.roughness = 0.9;
  model.materials["backdrop"] = paper;
  model.add("backdrop", "backdrop", backdrop());
  addLight(model, "overhead light", {5.2, 5.2, 5.2}, softBox({0, 3.0, 0.3}, {0, 0, 0.3}, 3.4, 1.5));
  addLight(model, "key light", {9.5, 9.0, 8.4}, softBox({4.2, 2.3, 2.4}, {0, 0.6, 0}, 1.5, 2.2));
  addLight(model, "side light", {5.0, 5.3, 5.8}, softBox({-4.6, 1.7, 3.0}, {0, 0.5, 0}, 1.2, 2.6));
  addLight(model, "edge light", {7.0, 7.2, 7.6},
           softBox({-2.6, 3.0, -1.8}, {-0.3, 0.6, 0}, 2.4, 0.7));
}

}  // namespace glimt::assets::motorcycle
