#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/shader/glsl_double.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/report.h"

using namespace glimt;

namespace {

// IEC 61966-2-1.
double exactSrgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double encoded(float linear) {
  return double(glsl_float::encodeSrgb(glm::vec3(linear)).x);
}

}  // namespace

TEST_CASE("the display transform is sRGB") {
  for (const float linear : {0.0f, 0.001f, 0.0031308f, 0.0032f, 0.18f, 0.5f, 1.0f}) {
    CAPTURE(linear);
    CHECK(encoded(linear) == Approx(exactSrgb(double(linear))).margin(3e-7));
  }
  CHECK(encoded(0) == 0);
  double worst = 0;
  for (int i = 0; i <= 100000; ++i) {
    const float linear = static_cast<float>(i) / 100000;
    worst = std::max(worst, std::abs(encoded(linear) - exactSrgb(double(linear))));
  }
  test::report("sRGB: off by up to {:.2e}", worst);
  CHECK(worst < 1e-6);
  CHECK(glsl_double::encodeSrgb(glm::dvec3(0.18)).x == Approx(exactSrgb(0.18)).epsilon(1e-14));
}

TEST_CASE("the display transform never falls as radiance rises") {
  double before = -1;
  int falls = 0;
  for (int i = 0; i <= 1000000; ++i) {
    const double now = encoded(static_cast<float>(i) * 1e-6f);
    if (now < before - 1e-7) ++falls;
    before = now;
  }
  CHECK(falls == 0);
}

TEST_CASE("the display transform exposes first and clips then") {
  const glm::vec3 out = glsl_float::displayTransform(glm::vec3(0.09f, 100.0f, -1.0f), 2.0f);
  CHECK(double(out.x) == Approx(exactSrgb(0.18)).margin(1e-6));
  CHECK(out.y == Approx(1).margin(1e-6));
  CHECK(out.z == 0);
}
