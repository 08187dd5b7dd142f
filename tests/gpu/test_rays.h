// Rays for tests of the traversal, as lists that a Probe takes.
#pragma once

#include <vector>

#include "renderer/core/bounds.h"

namespace glimt::test {

struct Rays {
  std::vector<Vec4> origins;
  std::vector<Vec4> directions;

  std::size_t size() const { return origins.size(); }
  Vec3 origin(std::size_t i) const { return Vec3(origins[i]); }
  Vec3 direction(std::size_t i) const { return Vec3(directions[i]); }
};

// Three quarters from anywhere in the box to anywhere, with directions of length one; the others
// side by side from a camera in the box.
Rays raysIn(const Bounds& box, std::size_t count);

// From far outside the box, up to a thousand times its size away, to anywhere in it.
Rays raysFromAfar(const Bounds& box, std::size_t count);

// Between two points of the box: what visibility() is asked about.
Rays segmentsIn(const Bounds& box, std::size_t count);

}  // namespace glimt::test
