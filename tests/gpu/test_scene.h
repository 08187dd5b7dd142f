// Scenes for tests of the traversal.
#pragma once

#include <optional>

#include "renderer/core/bounds.h"
#include "renderer/scene/scene.h"

namespace glimt::test {

// A closed, displaced torus knot of 70,000 triangles in a closed box. Triangle i has material i.
Scene knotInBox();

// reference/knot.obj, its triangles numbered in the same way; none where the file is not there,
// which is told.
std::optional<Scene> referenceKnot();

Bounds boundsOf(const Scene& scene);

}  // namespace glimt::test
