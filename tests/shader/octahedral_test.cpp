#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "tests/shader/glsl_double.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;

namespace {

// Along the axes, on the folds and beside them, with zeros of both signs.
std::vector<glm::vec3> awkwardDirections() {
  std::vector<glm::vec3> all;
  const std::vector<float> steps{0.0f, -0.0f, 1.0f, -1.0f, 1e-7f, -1e-7f, 1e-20f, -1e-20f, 0.5f};
  for (const float x : steps)
    for (const float y : steps)
      for (const float z : steps)
        if (std::abs(x) + std::abs(y) + std::abs(z) > 0.1f)
          all.push_back(glm::vec3(glm::normalize(glm::dvec3(x, y, z))));
  return all;
}

std::vector<glm::vec3> directions() {
  test::Random random(3);
  std::vector<glm::vec3> all = awkwardDirections();
  while (all.size() < 1000000) all.push_back(random.direction());
  return all;
}

bool inSquare(const glm::dvec2& p) {
  return std::abs(p.x) <= 1 && std::abs(p.y) <= 1;
}

}  // namespace

TEST_CASE("directions come back from the octahedral square") {
  double worst_float = 0;
  double worst_double = 0;
  int outside = 0;
  for (const glm::vec3& v : directions()) {
    const glm::dvec3 exact = glm::normalize(glm::dvec3(v));
    const glm::vec2 p = glsl_float::encodeOctahedral(v);
    if (!inSquare(p)) ++outside;
    const double angle = test::angleBetween(exact, glm::dvec3(glsl_float::decodeOctahedral(p)));
    worst_float = std::max(worst_float, angle);
    const glm::dvec2 q = glsl_double::encodeOctahedral(exact);
    worst_double =
        std::max(worst_double, test::angleBetween(exact, glsl_double::decodeOctahedral(q)));
  }
  test::report("octahedral: worst angle {:.2e} rad in float, {:.2e} in double", worst_float,
               worst_double);
  CHECK(outside == 0);
  CHECK(worst_float < 5e-7);
  CHECK(worst_double < 1e-15);
}

TEST_CASE("decoded octahedral directions have length one") {
  double worst = 0;
  test::Random random(4);
  for (int i = 0; i < 1000000; ++i) {
    const glm::vec3 v = glsl_float::decodeOctahedral(2.0f * random.square() - 1.0f);
    worst = std::max(worst, std::abs(glm::length(glm::dvec3(v)) - 1));
  }
  test::report("octahedral: lengths off by {:.2e}", worst);
  CHECK(worst < 3e-7);
}
