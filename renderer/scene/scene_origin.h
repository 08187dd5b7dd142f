// Where a scene's coordinates begin.
#pragma once

#include "renderer/core/vector.h"

namespace glimt {

// The centre of the model's box, in its file's coordinates, where the box is so far from their
// origin that floats would lose four bits or more of its details; else that origin.
glm::dvec3 sceneOriginOf(const glm::dvec3& low, const glm::dvec3& high);

}  // namespace glimt
