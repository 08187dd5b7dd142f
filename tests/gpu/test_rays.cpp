#include "tests/gpu/test_rays.h"

#include <cmath>

#include "tests/shader/random.h"

namespace glimt::test {
namespace {

Vec3 pointIn(const Bounds& box, Random& random) {
  const Vec3 p(random.uniform(), random.uniform(), random.uniform());
  return box.min + p * box.size();
}

void addCamera(Rays& rays, const Bounds& box, std::size_t count) {
  const Vec3 origin = box.min + Vec3(0.02f, 0.45f, 0.9f) * box.size();
  const Vec3 forward = glm::normalize(box.center() - origin);
  const Vec3 right = glm::normalize(glm::cross(forward, Vec3(0, 1, 0)));
  const Vec3 up = glm::cross(right, forward);
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 p = (Vec2(i % side, i / side) + 0.5f) / static_cast<float>(side) * 2.0f - 1.0f;
    rays.origins.emplace_back(origin, 0);
    rays.directions.emplace_back(glm::normalize(forward + p.x * right + p.y * up), 0);
  }
}

}  // namespace

Rays raysIn(const Bounds& box, std::size_t count) {
  Random random(40);
  Rays rays;
  for (std::size_t i = 0; i < count / 4 * 3; ++i) {
    rays.origins.emplace_back(pointIn(box, random), 0);
    rays.directions.emplace_back(random.direction(), 0);
  }
  addCamera(rays, box, count - rays.size());
  return rays;
}

Rays raysFromAfar(const Bounds& box, std::size_t count) {
  Random random(42);
  Rays rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 direction = random.direction();
    const float distance = glm::length(box.size()) * random.logUniform(2, 1e3f);
    rays.origins.emplace_back(pointIn(box, random) - distance * direction, 0);
    rays.directions.emplace_back(direction, 0);
  }
  return rays;
}

Rays segmentsIn(const Bounds& box, std::size_t count) {
  Random random(41);
  Rays rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 origin = pointIn(box, random);
    rays.origins.emplace_back(origin, 0);
    rays.directions.emplace_back(pointIn(box, random) - origin, 0);
  }
  return rays;
}

}  // namespace glimt::test
