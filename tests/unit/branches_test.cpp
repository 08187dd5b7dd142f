#include "renderer/shader/branches.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "renderer/shader/composer.h"
#include "tests/unit/expect_error.h"

using namespace glimt;

namespace {

const std::map<std::string, bool> kValues = {{"ON", true}, {"OFF", false}};

bool holds(const std::string& condition) {
  return takeBranches("#if " + condition + "\nyes\n#endif\n", kValues) == "yes\n";
}

// Without what stands behind `//`.
std::string withoutComments(const std::string& text) {
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) out += line.substr(0, line.find("//")) + '\n';
  return out;
}

// The shaders of all passes of a scene with those effects.
std::string shadersOf(const EffectSet& effects) {
  std::string text;
  for (const Pass pass : {Pass::camera, Pass::trace, Pass::escape, Pass::light, Pass::accumulate}) {
    ShaderRequest request;
    request.pass = pass;
    request.effects = effects;
    text += composeFragmentShader(request);
  }
  return text;
}

}  // namespace

TEST_CASE("conditions are read with their signs, in their order and by their parentheses") {
  CHECK(holds("ON"));
  CHECK_FALSE(holds("OFF"));
  CHECK(holds("!OFF && ON"));
  CHECK(holds("OFF || ON && ON"));
  CHECK_FALSE(holds("(OFF || ON) && OFF"));
  CHECK(holds("ON || OFF && OFF"));
  CHECK_FALSE(holds("!(ON || OFF)"));
  CHECK(holds("!!ON"));
}

TEST_CASE("the first branch whose condition holds is taken, and no other") {
  const std::string text = "a\n#if OFF\nb\n#elif ON\nc\n#elif ON\nd\n#else\ne\n#endif\nf\n";
  CHECK(takeBranches(text, kValues) == "a\nc\nf\n");
  CHECK(takeBranches("#if OFF\na\n#else\nb\n#endif\n", kValues) == "b\n");
}

TEST_CASE("branches within branches are taken only where those around them are") {
  const std::string inner = "#if ON\na\n#else\nb\n#endif\n";
  CHECK(takeBranches("#if ON\n" + inner + "c\n#endif\n", kValues) == "a\nc\n");
  CHECK(takeBranches("#if OFF\n" + inner + "c\n#else\nd\n#endif\n", kValues) == "d\n");
}

TEST_CASE("other directives stay as they are") {
  const std::string text = "#define A 1\n#ifdef A\na\n#else\nb\n#endif\n";
  CHECK(takeBranches(text, kValues) == text);
}

TEST_CASE("conditions that cannot be read are errors that show them") {
  for (const std::string condition : {"WHO", "ON &&", "(ON", "ON OFF", "ON == 1", ""}) {
    CAPTURE(condition);
    CHECK_THAT(messageOf(ErrorKind::failed, [&] { holds(condition); }),
               Catch::Contains("#if " + condition));
  }
  CHECK_THAT(messageOf(ErrorKind::failed, [&] { takeBranches("#if ON\n", kValues); }),
             Catch::Contains("does not end"));
}

TEST_CASE("a box with a lamp has no word of what it does not call for in its shaders") {
  EffectSet effects;
  effects.set(static_cast<std::size_t>(Effect::triangle_lights));
  const std::string text = withoutComments(shadersOf(effects));
  for (const std::string word :
       {"glass", "Glass", "mirror", "Mirror", "gloss", "Gloss", "ggx", "fresnel",
        "environmentRadiance", "sampleEnvironment", "fetchNormal", "escapedRadiance", "#if"}) {
    CAPTURE(word);
    CHECK(text.find(word) == std::string::npos);
  }
  CHECK(text.find("evalLambert") != std::string::npos);
}
