#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "renderer/core/wording.h"
#include "renderer/doctor/examination.h"
#include "renderer/gl/float_target.h"
#include "renderer/passes/scene_tree.h"

namespace glimt {
namespace {

using gl::FloatTarget;

// Hit record, sampling offsets, radiance, and the scene's nodes, triangles, materials, normals and
// lights: the light pass can need them all.
constexpr int kTextureUnits = 8;

std::string describe(FloatTarget target) {
  constexpr std::array kNames{"not complete", "complete but not exact", "exact"};
  return kNames[static_cast<std::size_t>(target)];
}

int integerOf(const gl::Context& context, GLenum name) {
  GLint value = 0;
  context.functions().GetIntegerv(name, &value);
  return value;
}

}  // namespace

Outcome examineContext(const gl::Context& context) {
  const ContextInfo& info = context.info();
  return {fmt::format("{}: {}, {}", info.backend, info.renderer, info.version), Verdict::ok,
          info.software ? "a rasteriser on the CPU; rays are traced on all cores"
                        : "rays are traced on this device"};
}

Outcome examineFloatTargets(const gl::Context& context) {
  const FloatTarget sized = tryFloatTarget(context.functions(), gl::FloatForm::sized);
  const FloatTarget unsized = tryFloatTarget(context.functions(), gl::FloatForm::unsized);
  const std::string result =
      fmt::format("RGBA32F {}, RGBA with FLOAT {}", describe(sized), describe(unsized));
  if (sized == FloatTarget::exact) return {result, Verdict::ok, "RGBA32F is used"};
  return verdictOf(unsized == FloatTarget::exact, result, "RGBA with FLOAT is used", Verdict::fatal,
                   "there is nothing to draw paths into; try another driver or --backend");
}

Outcome examinePrecisionClaim(const gl::Context& context) {
  std::array<GLint, 2> range{};
  GLint bits = 0;
  context.functions().GetShaderPrecisionFormat(GL_FRAGMENT_SHADER, GL_HIGH_FLOAT, range.data(),
                                               &bits);
  const std::string result = fmt::format("{} bits of mantissa, 2^-{} to 2^{} in fragment shaders",
                                         bits, range[0], range[1]);
  // 62 and 16 bits are what ES 2.0 wants of highp at the least; IEEE has 127 and 23.
  return verdictOf(bits >= 23 && std::min(range[0], range[1]) >= 126, result,
                   "fragment shaders have 32-bit floats", Verdict::fatal,
                   "fragment shaders lack the 23 bits and 2^126 that hit records are made of");
}

Outcome examineTextureSize(const gl::Context& context) {
  constexpr std::size_t kSmall = 500000;
  const int size = integerOf(context, GL_MAX_TEXTURE_SIZE);
  const std::size_t triangles = mostTriangles(std::max(size, 1));
  return {fmt::format("{} x {}", size, size), triangles < kSmall ? Verdict::warning : Verdict::ok,
          fmt::format("scenes of up to {}, pictures of up to {} pixels a side",
                      counted(triangles, "triangle"), size)};
}

Outcome examineTextureUnits(const gl::Context& context) {
  const int units = integerOf(context, GL_MAX_TEXTURE_IMAGE_UNITS);
  return verdictOf(units >= kTextureUnits, fmt::format("{}", units),
                   fmt::format("{} are needed", kTextureUnits), Verdict::fatal,
                   fmt::format("the light pass reads {} textures", kTextureUnits));
}

Outcome examineTimers(const gl::Context& context) {
  constexpr std::array kExtensions{"GL_EXT_disjoint_timer_query", "GL_ARB_timer_query"};
  for (const char* extension : kExtensions)
    if (context.hasExtension(extension))
      return {extension, Verdict::ok, "none: draws are timed by the clock"};
  return {"none", Verdict::ok, "none: draws are timed by the clock"};
}

}  // namespace glimt
