// The table of albedos, read as the shaders read it, against a fine quadrature.
#include <algorithm>
#include <catch2/catch.hpp>

#include "renderer/passes/gloss_table.h"
#include "renderer/passes/sheen_albedo.h"
#include "shaders/layout.h"
#include "tests/shader/bsdfs.h"
#include "tests/shader/report.h"

using namespace glimt;
using namespace glimt::test;

namespace {

using vec2 = glm::dvec2;
using vec4 = glm::dvec4;
using glm::clamp;
using glm::floor;
using glm::min;
using glm::mix;
using std::pow;
using sampler2D = std::vector<Vec4>;

vec4 texture2D(const sampler2D& table, const vec2& at) {
  const auto size = static_cast<std::size_t>(GLOSS_TABLE_SIZE);
  const auto column = static_cast<std::size_t>(at.x * GLOSS_TABLE_SIZE);
  const auto row = static_cast<std::size_t>(at.y * double(table.size()) / GLOSS_TABLE_SIZE);
  return vec4(table.at(row * size + column));
}

#define uniform
#define float double
#include "shaders/gloss_albedo.glsl"
#undef float
#undef uniform

// As the table's own function, with as many steps as it takes.
vec2 fineAlbedo(double cosine, double roughness, int steps) {
  const double alpha = std::max(roughness * roughness, 1e-6);
  const glm::dvec3 wo(std::sqrt(1 - cosine * cosine), 0, cosine);
  vec2 sum(0);
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      // Short steps where normals are seen edge-on.
      const double t = (j + 0.5) / steps;
      const vec2 at((i + 0.5) / steps, 1 - t * t);
      const glm::dvec3 wi = glsl_double::sampleGloss(wo, alpha, at);
      if (!(wi.z > 0)) continue;
      const glm::dvec3 normal = glm::normalize(wo + wi);
      const double weight = glsl_double::ggxMaskingShadowing(wo, wi, alpha) /
                            glsl_double::ggxMasking(wo, alpha) * 2 * t;
      const double horizon = std::pow(std::clamp(1 - glm::dot(wo, normal), 0.0, 1.0), 5);
      sum += vec2(1 - horizon, horizon) * weight;
    }
  return sum / double(steps * steps);
}

// Worst errors of cosines from 0.01 on, and below.
struct Worst {
  double above = 0;
  double below = 0;

  void add(double cosine, double error) {
    double& worst = cosine < 0.01 ? below : above;
    worst = std::max(worst, std::abs(error));
  }
};

}  // namespace

// Errors make light or lose it: half a percent is not seen. Below a cosine of 0.01, where a sphere
// shows a ten-thousandth of its disk, 2% are not.
TEST_CASE("the table of albedos is as good as a fine quadrature") {
  const double ior = 1.5;
  uGlossTable = glossTable(true, {1.5f});
  uGlossTableSquares = 2;
  Worst quadrature, gloss, horizon, sheen, glass;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) {
      const double cosine = std::max(std::pow(i / 40.0, 2), 1e-4);
      const double roughness = j / 40.0;
      const vec2 exact = fineAlbedo(cosine, roughness, 96);
      const vec2 coarse(glossAlbedoOf(cosine, roughness));
      const vec2 read = fetchGlossAlbedo(cosine, roughness);
      quadrature.add(cosine, coarse.x + coarse.y - exact.x - exact.y);
      gloss.add(cosine, read.x + read.y - exact.x - exact.y);
      horizon.add(cosine, read.y - exact.y);
      sheen.add(cosine, fetchSheenAlbedo(cosine, roughness) - sheenAlbedoOf(cosine, roughness));
      for (const bool leaving : {false, true})
        glass.add(cosine, fetchGlassAlbedo(1, cosine, roughness, leaving) -
                              glassAlbedoOf(cosine, roughness, leaving ? 1 / ior : ior));
    }
  const auto check = [](const char* name, const Worst& worst) {
    report("{}: off by {:.5f}, below a cosine of 0.01 by {:.5f}", name, worst.above, worst.below);
    INFO(name);
    CHECK(worst.above < 0.005);
    CHECK(worst.below < 0.02);
  };
  check("quadrature", quadrature);
  check("gloss", gloss);
  check("part with the reflectance at the horizon", horizon);
  check("sheen", sheen);
  check("rough glass", glass);
}
