#include <catch2/catch.hpp>

#include <cmath>

#include "tests/shader/glsl_double.h"
#include "tests/shader/glsl_float.h"

using namespace glimt;

namespace {

// What the wraps mean, in whole numbers.
int repeated(int i, int n) {
  return ((i % n) + n) % n;
}
int mirrored(int i, int n) {
  const int k = repeated(i, 2 * n);
  return k < n ? k : 2 * n - 1 - k;
}

}  // namespace

TEST_CASE("texels beyond the edges are those of integer arithmetic, for every size and far away") {
  for (const int size : {1, 2, 3, 5, 7, 64, 1000, 1023, 4096, 16384})
    for (const int center : {0, size, -size, 1000000, -1000003})
      for (int i = center - 20; i <= center + 20; ++i) {
        const auto at = static_cast<float>(i);
        const auto n = static_cast<float>(size);
        INFO("texel " << i << " of " << size);
        REQUIRE(glsl_float::wrapTexel(at, n, 0) == static_cast<float>(repeated(i, size)));
        REQUIRE(glsl_float::wrapTexel(at, n, 1) == static_cast<float>(mirrored(i, size)));
        REQUIRE(glsl_float::wrapTexel(at, n, 2) == static_cast<float>(std::clamp(i, 0, size - 1)));
      }
}

TEST_CASE("texels stay in the picture wherever the coordinates lead") {
  for (const float i : {1e9f, -1e20f, 3e38f})
    for (const float wrap : {0.0f, 1.0f, 2.0f}) {
      const float texel = glsl_float::wrapTexel(i, 100, wrap);
      CHECK(texel >= 0);
      CHECK(texel <= 99);
    }
}

TEST_CASE("sRGB is decoded as IEC 61966-2-1 says") {
  for (int value = 0; value < 256; ++value) {
    const double s = value / 255.0;
    const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    CHECK(glsl_double::decodeSrgb(s) == Approx(linear).epsilon(1e-12));
    CHECK(glsl_float::decodeSrgb(static_cast<float>(s)) == Approx(linear).epsilon(1e-5));
  }
}
