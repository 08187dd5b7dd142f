// How bright a colour looks.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "renderer/core/vector.h"

namespace glimt {

// Of linear radiance of Rec. 709 primaries, as shaders/luminance.glsl.
inline double luminance(const Vec3& radiance) {
  return glm::dot(glm::dvec3(radiance), glm::dvec3(0.2126, 0.7152, 0.0722));
}

}  // namespace glimt
