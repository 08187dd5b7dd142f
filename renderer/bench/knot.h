// A mesh with no two triangles alike: a tube along the (2,3) torus knot with a rippled surface.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/scene/scene.h"

namespace glimt {

struct KnotSize {
  std::uint32_t rings;
  std::uint32_t sides;
};

// 2 * rings * sides triangles, within 4 m of the origin.
void addKnot(Scene& scene, const KnotSize& size);

// Two triangles; corners are indices of positions, in the order around it.
void addQuad(Scene& scene, const std::array<std::uint32_t, 4>& corners, std::uint32_t material = 0);

}  // namespace glimt
