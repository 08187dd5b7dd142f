// What every tone promises, of the shaders' text.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/shader/glsl_double.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;

namespace {

using Display = glm::dvec3 (*)(glm::dvec3, double);

struct NamedDisplay {
  const char* name;
  Display display;
};

const NamedDisplay kAll[]{{"srgb", glsl_double::displayTransform},
                          {"agx", glsl_double::displayAgx},
                          {"aces", glsl_double::displayAces}};

double hueOf(const glm::dvec3& c) {
  return std::atan2(std::sqrt(3) * (c.g - c.b), 2 * c.r - c.g - c.b) * 180 / std::acos(-1.0);
}

double saturationOf(const glm::dvec3& c) {
  const double most = std::max({c.r, c.g, c.b});
  return most > 0 ? 1 - std::min({c.r, c.g, c.b}) / most : 0;
}

// The farthest that a colour's hue moves, in degrees, from what the display has for it while it is
// dim, as it grows very bright.
double hueTurn(const NamedDisplay& tone, const glm::dvec3& color) {
  double worst = 0;
  for (double stop = -4; stop <= 10; stop += 0.25) {
    const glm::dvec3 shown = tone.display(color, std::exp2(stop));
    if (saturationOf(shown) < 0.1) continue;  // as good as white, which has no hue
    const double dim = hueOf(glsl_double::encodeSrgb(color));
    worst = std::max(worst, std::abs(std::remainder(hueOf(shown) - dim, 360)));
  }
  return worst;
}

}  // namespace

TEST_CASE("every tone shows black as black, and everything within 0 to 1") {
  for (const NamedDisplay& tone : kAll) {
    CAPTURE(tone.name);
    CHECK(tone.display(glm::dvec3(0), 1) == glm::dvec3(0));
    CHECK(tone.display(glm::dvec3(-1), 1) == glm::dvec3(0));
    test::Random random(5);
    for (int i = 0; i < 100000; ++i) {
      const glm::dvec3 light(random.logUniform(1e-6f, 1e12f), random.logUniform(1e-6f, 1e12f),
                             random.logUniform(1e-6f, 1e12f));
      const glm::dvec3 shown = tone.display(light, 1);
      for (int c = 0; c < 3; ++c) REQUIRE((shown[c] >= 0 && shown[c] <= 1));
    }
    const glm::vec3 brightest = glsl_float::displayAces(glm::vec3(3e38f), 2);
    CHECK(brightest.r > 0.99f);
  }
}

TEST_CASE("every tone shows more light as brighter, from below a thousandth to white") {
  for (const NamedDisplay& tone : kAll) {
    CAPTURE(tone.name);
    double before = -1;
    for (double stop = -16; stop <= 16; stop += 0.001) {
      const double shown = tone.display(glm::dvec3(std::exp2(stop)), 1).g;
      REQUIRE(shown >= before - 1e-12);
      before = shown;
    }
    CHECK(before > 254.5 / 255);
  }
}

TEST_CASE("grey stays grey in every tone, and middle grey stays in the middle") {
  for (const NamedDisplay& tone : kAll) {
    CAPTURE(tone.name);
    for (const double light : {0.001, 0.18, 1.0, 8.0}) {
      const glm::dvec3 shown = tone.display(glm::dvec3(light), 1);
      CHECK(std::max({shown.r, shown.g, shown.b}) - std::min({shown.r, shown.g, shown.b}) <
            1 / 255.0);
    }
    const double middle = tone.display(glm::dvec3(0.18), 1).g;
    test::report("tone {}: middle grey is shown as {:.3f}, white as {:.3f}", tone.name, middle,
                 tone.display(glm::dvec3(1), 1).g);
    CHECK(middle > 0.38);
    CHECK(middle < 0.55);
  }
}

// Orange that is clipped turns yellow, sky blue turns cyan: a third of the way to the next primary.
TEST_CASE("agx keeps the hue of saturated bright colours better than clipping does") {
  for (const glm::dvec3& color : {glm::dvec3(1, 0.3, 0.02), glm::dvec3(0.02, 0.3, 1),
                                  glm::dvec3(1, 0.05, 0.4), glm::dvec3(0.3, 1, 0.05)}) {
    const double clipped = hueTurn(kAll[0], color);
    const double agx = hueTurn(kAll[1], color);
    test::report(
        "hue of ({}, {}, {}): turned by {:.1f} degrees when clipped, {:.1f} by agx, {:.1f} by aces",
        color.r, color.g, color.b, clipped, agx, hueTurn(kAll[2], color));
    CHECK(agx < clipped);
    CHECK(agx < 30);  // half of the way to the next primary or secondary colour
  }
}

TEST_CASE("the curves in floats are those in doubles, to a tenth of a display's step") {
  test::Random random(6);
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const glm::vec3 light(random.logUniform(1e-4f, 1e4f), random.logUniform(1e-4f, 1e4f),
                          random.logUniform(1e-4f, 1e4f));
    const glm::dvec3 agx = glm::dvec3(glsl_float::displayAgx(light, 1)) -
                           glsl_double::displayAgx(glm::dvec3(light), 1);
    const glm::dvec3 aces = glm::dvec3(glsl_float::displayAces(light, 1)) -
                            glsl_double::displayAces(glm::dvec3(light), 1);
    for (int c = 0; c < 3; ++c) worst = std::max({worst, std::abs(agx[c]), std::abs(aces[c])});
  }
  test::report("tones: floats are off by up to {:.2e}", worst);
  CHECK(worst < 0.1 / 255);
}
