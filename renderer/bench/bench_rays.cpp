#include "renderer/bench/bench_rays.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "renderer/bench/bench_mesh.h"

namespace glimt {
namespace {

constexpr float kLeaveSurface = 1e-4f;  // metres, far above rounding in a room of eight
constexpr float kBelowLight = 5e-3f;    // metres: the light itself does not block its light

// The same rays in every run.
class Random {
 public:
  explicit Random(std::uint32_t seed) : generator_(seed) {}
  float next() { return uniform_(generator_); }

 private:
  std::mt19937 generator_;
  std::uniform_real_distribution<float> uniform_{0, 1};
};

void add(Rays& rays, const Vec3& origin, const Vec3& direction) {
  rays.origins.emplace_back(origin, 0.0f);
  rays.directions.emplace_back(direction, 0.0f);
}

// Unit and uniform over the sphere.
Vec3 sampleSphere(Random& random) {
  const float z = 1 - 2 * random.next();
  const float angle = 2 * std::numbers::pi_v<float> * random.next();
  const float radius = std::sqrt(std::max(0.0f, 1 - z * z));
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

// `direction` is called with the point and the normal towards the camera ray's origin.
using Scatter = std::function<Vec3(const Vec3& point, const Vec3& normal)>;

Rays scatter(const Rays& camera, const std::vector<SurfaceHit>& hits, const Scatter& direction) {
  Rays rays;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].w < 0) {
      add(rays, Vec3(0), Vec3(0));
      continue;
    }
    const Vec3 incoming(camera.directions[i]);
    const Vec3 geometric(hits[i]);
    const Vec3 normal = glm::dot(geometric, incoming) > 0 ? -geometric : geometric;
    const Vec3 point = Vec3(camera.origins[i]) + incoming * hits[i].w + normal * kLeaveSurface;
    add(rays, point, direction(point, normal));
  }
  return rays;
}

}  // namespace

std::size_t Rays::countLive() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < size(); ++i) count += live(i);
  return count;
}

Rays makeCameraRays(const Camera& camera, int side) {
  Random random(7);
  const CameraFrame frame(camera);
  const auto onPicture = [&](int pixel) {
    return ((static_cast<float>(pixel) + random.next()) / static_cast<float>(side) * 2 - 1) *
           frame.half_height;
  };
  Rays rays;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const float x = onPicture(column);
      const float y = onPicture(row);
      add(rays, camera.position, glm::normalize(frame.forward + x * frame.right + y * frame.up));
    }
  return rays;
}

Rays makeBounceRays(const Rays& camera, const std::vector<SurfaceHit>& hits) {
  Random random(11);
  return scatter(camera, hits, [&](const Vec3&, const Vec3& normal) {
    const Vec3 direction = normal + sampleSphere(random);
    // Opposite to the normal, nothing would be left to normalise.
    return glm::length(direction) > 1e-3f ? glm::normalize(direction) : normal;
  });
}

Rays makeShadowRays(const Rays& camera, const std::vector<SurfaceHit>& hits) {
  Random random(13);
  return scatter(camera, hits, [&](const Vec3& point, const Vec3&) {
    const float x = (2 * random.next() - 1) * kLightHalfSide;
    const float z = (2 * random.next() - 1) * kLightHalfSide;
    return Vec3(x, kLightHeight - kBelowLight, z) - point;
  });
}

}  // namespace glimt
