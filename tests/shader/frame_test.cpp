#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/shader/glsl_double.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;

namespace {

// Random ones, and those around the poles, where the construction changes its side.
std::vector<glm::vec3> normals() {
  std::vector<glm::vec3> all{{0, 0, 1}, {0, 0, -1}, {1, 0, 0.0f}, {1, 0, -0.0f}, {0, -1, -0.0f}};
  test::Random random(13);
  while (all.size() < 200000) all.push_back(random.direction());
  while (all.size() < 400000) {
    const glm::vec2 off = random.logUniform(1e-20f, 1e-1f) * glm::vec2(random.direction());
    const double z = std::sqrt(1 - double(off.x) * off.x - double(off.y) * off.y);
    all.emplace_back(off, random.below(2) ? z : -z);
  }
  return all;
}

// Lengths of one, right angles, and the right hand.
template <class Frame>
double frameError(const Frame& frame) {
  const glm::dvec3 t(frame.tangent);
  const glm::dvec3 b(frame.bitangent);
  const glm::dvec3 n(frame.normal);
  return std::max({std::abs(glm::dot(t, t) - 1), std::abs(glm::dot(b, b) - 1),
                   std::abs(glm::dot(t, b)), std::abs(glm::dot(t, n)), std::abs(glm::dot(b, n)),
                   glm::length(glm::cross(t, b) - n)});
}

}  // namespace

TEST_CASE("frames are orthonormal and right-handed around every normal") {
  double worst_float = 0;
  double worst_double = 0;
  for (const glm::vec3& normal : normals()) {
    const auto frame = glsl_float::frameAround(normal);
    CHECK(frame.normal == normal);
    worst_float = std::max(worst_float, frameError(frame));
    const glm::dvec3 exact = glm::normalize(glm::dvec3(normal));
    worst_double = std::max(worst_double, frameError(glsl_double::frameAround(exact)));
  }
  test::report("frame: off by up to {:.2e} in float, {:.2e} in double", worst_float, worst_double);
  CHECK(worst_float < 1e-6);
  CHECK(worst_double < 2e-15);
}

TEST_CASE("a direction keeps its length and its cosine in a frame") {
  test::Random random(14);
  double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    const glm::vec3 normal = random.direction();
    const glm::vec3 local = random.direction();
    const glm::dvec3 world(glsl_float::fromFrame(glsl_float::frameAround(normal), local));
    worst = std::max({worst, std::abs(glm::length(world) - 1),
                      std::abs(glm::dot(world, glm::dvec3(normal)) - local.z)});
  }
  test::report("frame: a direction is off by up to {:.2e}", worst);
  CHECK(worst < 1e-6);
}
