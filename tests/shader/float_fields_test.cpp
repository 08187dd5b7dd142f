#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/shader/glsl_double.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"

using namespace glimt;

namespace {

std::vector<float> mantissas() {
  test::Random random(1);
  std::vector<float> all{0, 1, 2, 0x1p22f - 1, 0x1p22f, 0x1p22f + 1, 0x1p23f - 2, 0x1p23f - 1};
  while (all.size() < 2048) all.push_back(static_cast<float>(random.below(1u << 23)));
  return all;
}

// Counts what does not come back, over all exponents and four lanes at a time.
template <class Vec, class Join, class Split>
int countRoundTripErrors(const Join& join, const Split& split) {
  const std::vector<float> all = mantissas();
  int errors = 0;
  for (int exponent = -64; exponent < 64; ++exponent) {
    for (std::size_t i = 0; i < all.size(); i += 4) {
      const Vec mantissa(all[i], all[i + 1], all[i + 2], all[i + 3]);
      const Vec exponents(exponent, -exponent - 1, exponent, exponent);
      const auto [m, e] = split(join(mantissa, exponents));
      if (m != mantissa || e != exponents) ++errors;
    }
  }
  return errors;
}

}  // namespace

TEST_CASE("powers of two are exact") {
  for (int exponent = -64; exponent < 64; ++exponent) {
    const auto e = static_cast<float>(exponent);
    CHECK(glsl_float::powerOfTwo(glm::vec4(e)) == glm::vec4(std::ldexp(1.0f, exponent)));
    CHECK(glsl_double::powerOfTwo(glm::dvec4(e)) == glm::dvec4(std::ldexp(1.0, exponent)));
  }
}

TEST_CASE("every exponent and mantissa comes back from a float") {
  CHECK(countRoundTripErrors<glm::vec4>(
            [](auto m, auto e) { return glsl_float::joinFields(glsl_float::FloatFields(m, e)); },
            [](auto v) { return glsl_float::splitFields(v); }) == 0);
  CHECK(countRoundTripErrors<glm::dvec4>(
            [](auto m, auto e) { return glsl_double::joinFields(glsl_double::FloatFields(m, e)); },
            [](auto v) { return glsl_double::splitFields(v); }) == 0);
}

TEST_CASE("a float just below a power of two keeps the lower exponent") {
  for (int exponent = -40; exponent <= 87; ++exponent) {
    CAPTURE(exponent);
    const float below = std::nextafter(std::ldexp(1.0f, exponent), 0.0f);
    const auto fields = glsl_float::splitFields(glm::vec4(below));
    CHECK(fields.mantissa == glm::vec4(0x1p23f - 1));
    CHECK(fields.exponent == glm::vec4(static_cast<float>(exponent - 24)));
  }
}

TEST_CASE("every float in the range is its fields joined") {
  test::Random random(2);
  int errors = 0;
  for (int i = 0; i < 1000000; ++i) {
    const float value =
        std::ldexp(1.0f + random.uniform(), static_cast<int>(random.below(128)) - 41);
    const auto fields = glsl_float::splitFields(glm::vec4(value));
    if (glsl_float::joinFields(fields) != glm::vec4(value)) ++errors;
  }
  CHECK(errors == 0);
}
