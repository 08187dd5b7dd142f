#include "tests/gpu/exact_hits.h"

#include <algorithm>
#include <cmath>

namespace glimt::test {
namespace {

// Relative error of a corner's position seen from the origin, with a few roundings more.
constexpr double kRounding = 1e-6;

}  // namespace

ExactHits::ExactHits(const Scene& scene, const Vec3& origin, const Vec3& direction)
    : length_(glm::length(glm::dvec3(direction))) {
  const glm::dvec3 o(origin);
  const glm::dvec3 d = glm::dvec3(direction) / length_;
  double size = 0;
  for (const Vec3& position : scene.positions)
    size = std::max(size, glm::length(glm::dvec3(position) - o));
  doubt_ = kRounding * size;

  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    glm::dvec3 v[3];
    for (int k = 0; k < 3; ++k)
      v[k] =
          glm::dvec3(scene.positions[scene.triangles[i].positions[static_cast<std::size_t>(k)]]) -
          o;
    const glm::dvec3 normal = glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
    const double facing = glm::dot(normal, d);
    double inside = INFINITY;
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 edge = v[(k + 1) % 3] - v[k];
      // Distance between the ray's line and the edge's.
      const glm::dvec3 across = glm::cross(edge, d);
      const double distance = glm::dot(v[k], across) / glm::length(across);
      inside = std::min(inside, facing > 0 ? distance : -distance);
    }
    if (!(inside > -doubt_) || facing == 0) continue;
    const double t = glm::dot(v[0], normal) / facing;
    hits_.push_back({i, t / length_, inside, std::abs(facing)});
  }
}

double ExactHits::steepness(std::uint32_t triangle) const {
  for (const Hit& hit : hits_)
    if (hit.triangle == triangle) return hit.steepness;
  return 1;
}

double ExactHits::slack(const Hit& hit) const {
  return 1e-5 * hit.t + doubt_ / hit.steepness / length_;
}

bool ExactHits::allows(const std::optional<MeshHit>& answer) const {
  double limit = answer ? double(answer->t) : INFINITY;
  bool found = !answer;
  for (const Hit& hit : hits_) {
    if (answer && hit.triangle == answer->triangle) found = std::abs(hit.t - limit) <= slack(hit);
  }
  const bool hidden = std::any_of(hits_.begin(), hits_.end(), [&](const Hit& hit) {
    return hit.inside > doubt_ && hit.t > slack(hit) && hit.t < limit - slack(hit);
  });
  return found && !hidden;
}

bool ExactHits::allowsOccluded(bool answer) const {
  const bool surely = std::any_of(hits_.begin(), hits_.end(), [&](const Hit& hit) {
    return hit.inside > doubt_ && hit.t > slack(hit) && hit.t < 1 - slack(hit);
  });
  const bool perhaps = std::any_of(hits_.begin(), hits_.end(), [&](const Hit& hit) {
    return hit.t > -slack(hit) && hit.t < 1 + slack(hit);
  });
  return answer ? perhaps : !surely;
}

}  // namespace glimt::test
