// A form of float texture that calls itself complete may still hold 8 bits.
#include <algorithm>
#include <catch2/catch.hpp>

#include "renderer/core/error.h"
#include "renderer/gl/float_target.h"
#include "renderer/shader/composer.h"
#include "tests/gpu/contexts.h"
#include "tests/gpu/probe.h"
#include "tests/shader/report.h"

using namespace glimt;
using gl::FloatForm;
using gl::FloatTarget;

namespace {

constexpr const char* kOutcomes[]{"not complete", "complete but not exact", "exact"};

// Draws large whole numbers into a target of this form, and reads them back.
FloatTarget drawInto(const test::TestContext& context, FloatForm form) {
  constexpr int kSize = 64;
  const gl::Device& device = context.device();
  try {
    const gl::Target target(gl::Texture::floats(device.gl(), form, kSize, 1));
    gl::Program program(device.gl(), "numbers", composeVertexShader(),
                        composeProbe({},
                                     "void main() { writeTexel(vec4(16777152.0 + "
                                     "floor(pixelCenter().x), -0.5, 0.25, 3.0)); }"));
    program.use();
    program.set("uZero", Vec4(0));
    target.bind();
    device.draw({0, 0, kSize, 1});
    const std::vector<Vec4> texels = target.readFloats();
    for (int i = 0; i < kSize; ++i) {
      const Vec4 expected(16777152.0f + static_cast<float>(i), -0.5f, 0.25f, 3.0f);
      if (texels[static_cast<std::size_t>(i)] != expected) return FloatTarget::inexact;
    }
    return FloatTarget::exact;
  } catch (const Error&) {
    return FloatTarget::incomplete;
  }
}

}  // namespace

TEST_CASE("float forms are accepted where they keep floats, and refused elsewhere") {
  test::onEveryContext([](const test::TestContext& context) {
    CAPTURE(context.name());
    for (const FloatForm form : {FloatForm::sized, FloatForm::unsized}) {
      const FloatTarget outcome = drawInto(context, form);
      test::report("{}: {} float textures are {}", context.name(),
                   form == FloatForm::sized ? "sized" : "unsized",
                   kOutcomes[static_cast<int>(outcome)]);
      CHECK(gl::tryFloatTarget(context.gl(), form) == outcome);
      const auto found = gl::findFloatForm(context.gl(), {form});
      CHECK(found.has_value() == (outcome == FloatTarget::exact));
      if (found) CHECK(*found == form);
    }
  });
}

TEST_CASE("a form that quietly gives 8 bits is passed over") {
  const auto& all = test::contexts();
  const auto quiet = std::find_if(all.begin(), all.end(), [](const test::TestContext& context) {
    context.makeCurrent();
    return drawInto(context, FloatForm::unsized) == FloatTarget::inexact;
  });
  if (quiet == all.end()) {
    test::report("skipped: no context here has such a form");
    return;
  }
  const auto& gl = quiet->gl();
  CHECK_FALSE(gl::findFloatForm(gl, {FloatForm::unsized}).has_value());
  CHECK(gl::findFloatForm(gl, {FloatForm::unsized, FloatForm::sized}) == FloatForm::sized);
}
