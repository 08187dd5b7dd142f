// Some drivers compute mediump in 16 bits. The prelude guards against it in several places; each is
// tested with its guard, and without it to see whether the guard is needed.
#include <catch2/catch.hpp>

#include "renderer/probes/guard_probes.h"
#include "renderer/probes/number_probes.h"
#include "renderer/shader/composer.h"
#include "renderer/shader/records.h"
#include "tests/gpu/contexts.h"
#include "tests/shader/report.h"

using namespace glimt;
using test::TestContext;

namespace {

bool isLlvmpipe(const TestContext& context) {
  const std::string renderer = context.device().info().renderer;
  return context.egl() && renderer.find("llvmpipe") != std::string::npos;
}

std::size_t countOf(const std::string& word, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++count;
  return count;
}

}  // namespace

TEST_CASE("numbers of all sizes and all integers of 24 bits are stored and fetched exactly") {
  test::onEveryContext([&](const TestContext& context) {
    CAPTURE(context.name());
    const NumbersProbe scaled = probeScaledIntegers(context.device());
    CHECK(scaled.wrong == 0);
    CHECK(scaled.texels == 1u << 20);
    const NumbersProbe integers = probeAllIntegers(context.device());
    CHECK(integers.wrong == 0);
    CHECK(integers.texels == 1u << 23);  // of four each, half of them negative
  });
}

TEST_CASE("texels, pixel centres beyond 2048 and calculated numbers are exact, thanks to guards") {
  test::onEveryContext([&](const TestContext& context) {
    for (const GuardProbe& probe : probeGuards(context.device())) {
      CAPTURE(context.name(), probe.guard);
      CHECK(probe.texels > 1u << 18);
      CHECK(probe.wrong == 0);
      test::report("{}: without {}: {} of {} wrong{}", context.name(), probe.guard,
                   probe.wrong_without, probe.texels,
                   probe.wrong_without ? "" : "; here this guard alone would not be missed");
      // The others are known to be needed.
      if (isLlvmpipe(context) && probe.guard != kGuardOfSum) CHECK(probe.wrong_without > 0);
    }
  });
}

// The test above shows why.
TEST_CASE("every pass writes its texel once, under no condition") {
  const std::string prelude = shaderText("prelude.glsl");
  for (const Record& record : records())
    for (const Pass pass :
         {Pass::camera, Pass::trace, Pass::escape, Pass::light, Pass::accumulate, Pass::close_block,
          Pass::first_hit, Pass::delta, Pass::guide, Pass::guide_sum, Pass::keep, Pass::change,
          Pass::prepare, Pass::neighbours, Pass::atrous, Pass::finish, Pass::display}) {
      CAPTURE(record.name, nameOf(pass));
      ShaderRequest request;
      request.pass = pass;
      request.record = record.name;
      request.gles = record.gles;
      request.effects.set();
      const std::string text = composeFragmentShader(request);
      const std::string start = record.gles < 3 ? prelude : prelude + shaderText("es3.glsl");
      CHECK(countOf("writeTexel(", text) == countOf("writeTexel(", prelude) + 1);
      CHECK(countOf("\n  writeTexel(", text) == 1);  // in main, or in what it ends with
      CHECK(countOf("gl_FragColor", text) == countOf("gl_FragColor", start));
    }
}
