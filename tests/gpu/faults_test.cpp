// Drivers that fail: what is said, and what is left of the picture.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <functional>
#include <new>
#include <string>
#include <utility>

#include "app/sampling.h"
#include "renderer/gl/errors.h"
#include "tests/gpu/altered_context.h"
#include "tests/gpu/contexts.h"
#include "tests/image/pictures.h"
#include "tests/image/scenes.h"
#include "tests/unit/expect_error.h"

using namespace glimt;

namespace {

constexpr int kSize = 16;
constexpr int kBounces = 1;
constexpr GLenum kGuiltyReset = 0x8253;
constexpr int kNever = 1 << 30;

// What the fake driver does. Functions of GL know nothing but their arguments.
struct Faults {
  int good_draws = kNever;     // before the one that fails
  int good_textures = kNever;  // before the one for which there is no memory
  int good_finishes = kNever;  // before the one that finds out what a draw came to
  GLenum draw_error = GL_OUT_OF_MEMORY;
  bool reset = false;   // a failing draw loses the context
  bool throws = false;  // or the CPU's memory is what is used up
  GLenum error = GL_NO_ERROR;
  bool lost = false;
};
Faults faults;

const gl::Functions& real() {
  return test::contexts().front().gl();
}

void draw(GLenum mode, GLint first, GLsizei count) {
  if (faults.good_draws-- > 0) return real().DrawArrays(mode, first, count);
  if (faults.throws) throw std::bad_alloc();
  faults.lost = faults.reset;
  if (!faults.reset) faults.error = faults.draw_error;
}

void makeTexture(GLenum target, GLint level, GLint internal_format, GLsizei width, GLsizei height,
                 GLint border, GLenum format, GLenum type, const void* texels) {
  if (faults.good_textures-- > 0)
    return real().TexImage2D(target, level, internal_format, width, height, border, format, type,
                             texels);
  faults.error = GL_OUT_OF_MEMORY;
}

void finish() {
  real().Finish();
  if (faults.good_finishes-- <= 0) faults.error = GL_OUT_OF_MEMORY;
}

// A lost context does nothing, and says nothing where it does not have to.
void readPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                void* pixels) {
  if (!faults.lost) real().ReadPixels(x, y, width, height, format, type, pixels);
}

GLenum getError() {
  const GLenum real_error = real().GetError();
  return faults.error != GL_NO_ERROR ? std::exchange(faults.error, GL_NO_ERROR) : real_error;
}

// Once, as a driver does that has come back; the context stays lost.
GLenum resetStatus() {
  return faults.lost && std::exchange(faults.reset, false) ? kGuiltyReset : GL_NO_ERROR;
}

const GLubyte* getString(GLenum name) {
  static std::string extensions;
  const GLubyte* const text = real().GetString(name);
  if (name != GL_EXTENSIONS) return text;
  extensions = std::string(reinterpret_cast<const char*>(text)) + " GL_EXT_robustness";
  return reinterpret_cast<const GLubyte*>(extensions.c_str());
}

void failToCompile(GLuint, GLenum name, GLint* value) {
  *value = name == GL_COMPILE_STATUS ? GL_FALSE : 64;
}

void compilerLog(GLuint, GLsizei size, GLsizei* written, GLchar* log) {
  const int length = std::snprintf(log, static_cast<std::size_t>(size),
                                   "0:1(1): error: too many registers\nand more");
  *written = std::min(length, size - 1);
}

GLenum incompleteFramebuffer(GLenum) {
  return GL_FRAMEBUFFER_UNSUPPORTED;
}

ContextHandle failingContext(const Faults& wanted,
                             const std::function<void(gl::Functions&)>& alter = {}) {
  const test::TestContext& first = test::contexts().front();
  first.makeCurrent();
  gl::clearErrors(first.gl());
  faults = wanted;
  return ContextHandle(test::alteredContext(first.context(), [&](gl::Functions& functions) {
    functions.DrawArrays = draw;
    functions.Finish = finish;
    functions.TexImage2D = makeTexture;
    functions.ReadPixels = readPixels;
    functions.GetError = getError;
    functions.GetString = getString;
    functions.GetGraphicsResetStatus = resetStatus;
    if (alter) alter(functions);
  }));
}

Scene scene() {
  return test::furnace(0.5f);
}

RenderSettings settings() {
  return test::settingsFor(kSize, kBounces);
}

// What a driver without faults makes of so many samples, and in how many draws and textures.
struct Sound {
  Image radiance;
  int draws;
  int textures;
};
Sound sound(int samples) {
  ContextHandle context = failingContext({});
  Renderer renderer(context, scene(), settings());
  const int textures = kNever - faults.good_textures;
  while (renderer.samples() < samples) renderer.renderSample();
  const int draws = kNever - faults.good_draws;
  return {renderer.radiance(), draws, textures};
}

std::string errorWhileSampling(Renderer& renderer) {
  return messageOf(ErrorKind::failed, [&] {
    for (int i = 0; i < 100; ++i) renderer.renderSample();
  });
}

Sampling sample(Renderer& renderer, double seconds_at_risk) {
  const Interrupt interrupt;
  Progress progress(false);
  return sampleUntil(renderer, {1000, {}, {}}, interrupt, progress, seconds_at_risk);
}

void checkSound(const Picture& picture) {
  CAPTURE(picture.samples);
  CHECK(picture.nonfinite_pixels == 0);
  CHECK(test::identical(picture.radiance, sound(picture.samples).radiance));
}

// As far as it is complete: where GL turns out to have failed only when the last draw is waited
// for, pixels may have one sample more than is counted. Each has the mean of its own.
void checkSoundToOneMore(const Picture& picture) {
  CAPTURE(picture.samples);
  CHECK(picture.nonfinite_pixels == 0);
  const Image fewer = sound(picture.samples).radiance;
  const Image more = sound(picture.samples + 1).radiance;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < fewer.pixels.size(); ++i) {
    const Vec3& pixel = picture.radiance.pixels[i];
    wrong += pixel != fewer.pixels[i] && pixel != more.pixels[i];
  }
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("out of memory in any draw of a sample leaves the complete samples") {
  const int before = sound(2).draws;
  const int after = sound(3).draws;
  REQUIRE(after - before >= 4);  // camera, light, trace and light, accumulate
  for (int draws = before; draws < after; ++draws) {
    CAPTURE(draws);
    ContextHandle context = failingContext({.good_draws = draws});
    Renderer renderer(context, scene(), settings());
    CHECK_THAT(errorWhileSampling(renderer),
               Catch::Contains("GL is out of memory while drawing the pass "));
    const Picture picture = renderer.picture();
    CHECK(picture.samples == 2);
    checkSound(picture);
  }
}

TEST_CASE("out of memory while the noise is measured leaves the sample before it too") {
  ContextHandle context = failingContext({.good_draws = sound(4).draws - 1});
  Renderer renderer(context, scene(), settings());
  CHECK_THAT(errorWhileSampling(renderer),
             Catch::Contains("GL is out of memory while drawing the pass keep"));
  const Picture picture = renderer.picture();
  CHECK(picture.samples == 4);
  checkSound(picture);
}

TEST_CASE(
    "a draw that turns out to have failed when it is waited for leaves the samples before, or one "
    "more") {
  const int finishes = sound(3).draws;  // one for each
  for (int more = 0; more < 6; ++more) {
    CAPTURE(more);
    ContextHandle context = failingContext({.good_finishes = finishes + more});
    Renderer renderer(context, scene(), settings());
    CHECK_THAT(errorWhileSampling(renderer), Catch::Contains("out of memory"));
    const Picture picture = renderer.picture();
    CHECK(picture.samples >= 3);
    checkSoundToOneMore(picture);
  }
}

TEST_CASE("other errors of draws end a render too, and are named") {
  ContextHandle context =
      failingContext({.good_draws = 40, .draw_error = GL_INVALID_FRAMEBUFFER_OPERATION});
  Renderer renderer(context, scene(), settings());
  CHECK_THAT(errorWhileSampling(renderer),
             Catch::Contains("GL error 0x0506 (invalid framebuffer operation) while drawing"));
}

TEST_CASE("a lost context is told, and no picture is read from it") {
  ContextHandle context = failingContext({.good_draws = 40, .reset = true});
  Renderer renderer(context, scene(), settings());
  CHECK_THAT(errorWhileSampling(renderer),
             Catch::Contains("the GL context was lost") &&
                 Catch::Contains("reset because of this program's draws"));
  CHECK_THAT(messageOf(ErrorKind::failed, [&] { renderer.picture(); }),
             Catch::Contains("cannot be read back"));
}

TEST_CASE("sampling that runs out of memory comes back with all samples") {
  ContextHandle context = failingContext({.good_draws = 50});
  Renderer renderer(context, scene(), settings());
  const Sampling sampling = sample(renderer, 1000);
  CHECK_THAT(sampling.failure, Catch::Contains("GL is out of memory"));
  CHECK(sampling.samples > 1);
  CHECK(sampling.picture.samples == sampling.samples);
  checkSound(sampling.picture);
}

TEST_CASE("sampling that fails on the CPU comes back with all samples") {
  ContextHandle context = failingContext({.good_draws = 50, .throws = true});
  Renderer renderer(context, scene(), settings());
  const Sampling sampling = sample(renderer, 1000);
  CHECK(sampling.failure == "out of memory");
  CHECK(sampling.picture.samples == sampling.samples);
  checkSound(sampling.picture);
}

TEST_CASE("sampling that loses the context comes back with the samples kept before") {
  const int draws = sound(400).draws;
  for (const double seconds_at_risk : {0.0, 1000.0}) {
    CAPTURE(seconds_at_risk);
    ContextHandle context = failingContext({.good_draws = draws, .reset = true});
    Renderer renderer(context, scene(), settings());
    const Sampling sampling = sample(renderer, seconds_at_risk);
    CHECK_THAT(sampling.failure, Catch::Contains("the GL context was lost"));
    CHECK(sampling.samples > 1);
    CHECK(sampling.samples <= 400);  // the last draws may be those that measure the noise
    CHECK(sampling.picture.samples >= 1);
    CHECK(sampling.picture.samples <= sampling.samples);
    if (seconds_at_risk > 0) CHECK(sampling.picture.samples == 1);  // the first is kept at once
    checkSound(sampling.picture);
  }
}

TEST_CASE("sampling that fails before the first sample has nothing to hand out") {
  ContextHandle context = failingContext({.good_draws = 1});
  Renderer renderer(context, scene(), settings());
  CHECK_THAT(messageOf(ErrorKind::failed, [&] { sample(renderer, 1000); }),
             Catch::Contains("GL is out of memory"));
}

TEST_CASE("a shader that does not compile is named, with what the driver says of it") {
  ContextHandle context = failingContext({}, [](gl::Functions& functions) {
    functions.GetShaderiv = failToCompile;
    functions.GetShaderInfoLog = compilerLog;
  });
  CHECK_THAT(messageOf(ErrorKind::failed, [&] { Renderer(context, scene(), settings()); }),
             Catch::Contains("the shader 'accumulate' does not compile: 0:1(1): error: too many "
                             "registers"));
}

TEST_CASE("out of memory for any texture is one clear error, or is got around") {
  const int textures = sound(1).textures;
  int told = 0;
  for (int good = 0; good < textures; ++good) {
    CAPTURE(good);
    ContextHandle context = failingContext({.good_textures = good});
    try {
      Renderer(context, scene(), settings());
    } catch (const Error& error) {
      const std::string message = error.what();
      CHECK((error.kind() == ErrorKind::no_gl || error.kind() == ErrorKind::failed));
      CHECK(message.find('\n') == std::string::npos);
      told += message.find("GL is out of memory while making a texture") != std::string::npos;
    }
  }
  // All but those by which the device is tried out.
  CHECK(told >= textures - 4);
}

TEST_CASE("a device that cannot draw into anything, or has none left, is no usable GL") {
  const auto message = [](const Faults& wanted, const std::function<void(gl::Functions&)>& alter) {
    return messageOf(ErrorKind::no_gl, [&] {
      ContextHandle context = failingContext(wanted, alter);
      Renderer(context, scene(), settings());
    });
  };
  CHECK_THAT(message({},
                     [](gl::Functions& functions) {
                       functions.CheckFramebufferStatus = incompleteFramebuffer;
                     }),
             Catch::Contains("cannot draw into textures of 32-bit floats"));
  CHECK_THAT(message({.reset = true, .lost = true}, {}), Catch::Contains("context"));
}

TEST_CASE("a context without the extension is not asked whether it was lost") {
  const test::TestContext& first = test::contexts().front();
  first.makeCurrent();
  const auto altered = test::alteredContext(first.context(), [](gl::Functions& functions) {
    functions.GetGraphicsResetStatus = resetStatus;
    functions.GetString = [](GLenum) { return reinterpret_cast<const GLubyte*>("GL_EXT_other"); };
  });
  CHECK(altered->functions().GetGraphicsResetStatus == nullptr);
}
