#include "renderer/scene/scene_origin.h"

namespace glimt {

glm::dvec3 sceneOriginOf(const glm::dvec3& low, const glm::dvec3& high) {
  constexpr double kFar = 16;  // of the model's size
  const glm::dvec3 center = 0.5 * low + 0.5 * high;
  return glm::length(center) > kFar * glm::distance(low, high) ? center : glm::dvec3(0);
}

}  // namespace glimt
