// All hits of a ray in double precision, by trying every triangle: the judge where two renderers
// differ.
#pragma once

#include <optional>
#include <vector>

#include "renderer/bench/embree_scene.h"
#include "renderer/scene/scene.h"

namespace glimt::test {

class ExactHits {
 public:
  ExactHits(const Scene& scene, const Vec3& origin, const Vec3& direction);

  // Whether an answer in single precision is right: what it hit is hit, or missed by no more than
  // rounding, and nothing that is surely hit lies in front of it.
  bool allows(const std::optional<MeshHit>& answer) const;

  // Sine of the angle between the ray and a triangle that it hits, or nearly hits; else 1.
  double steepness(std::uint32_t triangle) const;

  // The same as allows() for the question whether anything lies before `direction`'s end.
  bool allowsOccluded(bool answer) const;

 private:
  struct Hit {
    std::uint32_t triangle;
    double t;
    double inside;     // metres from the nearest edge, negative outside
    double steepness;  // sine of the angle between ray and triangle
  };

  // How much two distances may differ by rounding.
  double slack(const Hit& hit) const;

  std::vector<Hit> hits_;  // those inside, or nearly so
  double doubt_;           // metres
  double length_;          // of the direction
};

}  // namespace glimt::test
