// Whatever a scene calls for compiles: no effect, each alone, each pair, and all of them.
#include <catch2/catch.hpp>

#include "renderer/gl/device.h"
#include "renderer/gl/program.h"
#include "renderer/renderer.h"
#include "renderer/scene/effects_of.h"
#include "renderer/shader/composer.h"
#include "tests/shader/report.h"

using namespace glimt;

namespace {

// How many programs were made. One that does not compile or link is an error that names its pass.
int compileAll(const gl::Device& device, const EffectSet& effects) {
  int programs = 0;
  for (const Pass pass : {Pass::camera, Pass::trace, Pass::escape, Pass::light}) {
    ShaderRequest request;
    request.pass = pass;
    request.effects = withImplied(effects);
    request.additive_blending = device.floatBlending();
    CAPTURE(nameOf(pass), effects.to_string());
    CHECK_NOTHROW(gl::Program(device.gl(), nameOf(pass), composeVertexShader(),
                              composeFragmentShader(request)));
    ++programs;
  }
  return programs;
}

EffectSet of(int first, int second) {
  EffectSet effects;
  effects.set(static_cast<std::size_t>(first));
  effects.set(static_cast<std::size_t>(second));
  return effects;
}

}  // namespace

TEST_CASE("no effect, each effect alone, and all effects compile on EGL and OSMesa") {
  for (const Backend backend : {Backend::egl, Backend::osmesa}) {
    ContextHandle context = createOffscreenContext(backend, 2);
    const gl::Device device(context.get());
    compileAll(device, EffectSet());
    compileAll(device, EffectSet().set());
    for (int i = 0; i < kEffectCount; ++i) compileAll(device, of(i, i));
  }
}

TEST_CASE("all pairs of effects compile") {
  ContextHandle context = createOffscreenContext(Backend::automatic, 2);
  const gl::Device device(context.get());
  int programs = 0;
  for (int i = 0; i < kEffectCount; ++i)
    for (int j = 0; j < i; ++j) programs += compileAll(device, of(i, j));
  test::report("{} programs of pairs of effects", programs);
  CHECK(programs == 4 * kEffectCount * (kEffectCount - 1) / 2);
}
