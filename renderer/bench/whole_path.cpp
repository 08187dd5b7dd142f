#include "renderer/bench/whole_path.h"

#include <fmt/format.h>

#include "renderer/passes/camera_uniforms.h"
#include "renderer/scene/effects_of.h"
#include "renderer/shader/composer.h"
#include "renderer/shader/traversals.h"

namespace glimt {
namespace {

// Points of the light samples at each surface, and of the directions in which paths leave it.
constexpr const char* kPoints = R"(
uniform vec4 uLightPoints[SURFACES];
uniform vec4 uLightShifts[SURFACES];
uniform vec4 uScatterPoints[SURFACES];
uniform vec4 uScatterShifts[SURFACES];
)";

constexpr const char* kLoopBody = R"(
  for (int i = 0; i < SURFACES; i++) {
    vec4 light = shiftedPoint(pixel, uLightPoints[i], uLightShifts[i]);
    meetSurface(path, light, i == 0, i == SURFACES - 1);
    if (path.ended || i == SURFACES - 1) break;
    scatterPath(path, shiftedPoint(pixel, uScatterPoints[i], uScatterShifts[i]));
  }
)";

std::string unrolledBody(int surfaces) {
  std::string text;
  for (int i = 0; i < surfaces; ++i) {
    const bool last = i == surfaces - 1;
    text += fmt::format(
        "  meetSurface(path, shiftedPoint(pixel, uLightPoints[{0}], uLightShifts[{0}]), {1}, "
        "{2});\n",
        i, i == 0, last);
    if (!last)
      text += fmt::format(
          "  scatterPath(path, shiftedPoint(pixel, uScatterPoints[{0}], uScatterShifts[{0}]));\n",
          i);
  }
  return text;
}

std::string pathText(int surfaces, PathForm form) {
  return fmt::format("#define SURFACES {}\n{}", surfaces, kPoints) +
         "void main() {\n"
         "  vec2 pixel = pixelCenter();\n"
         "  Path path = startPath(cameraRay(pixel, samplePoint(pixel)));\n" +
         (form == PathForm::loop ? kLoopBody : unrolledBody(surfaces)) +
         "  writeTexel(vec4(path.radiance, 0.0));\n"
         "}\n";
}

}  // namespace

WholePathTracer::WholePathTracer(const gl::Device& device, const Scene& scene,
                                 const SceneTextures& textures, const PathTracerSettings& settings,
                                 PathForm form)
    : device_(&device),
      textures_(&textures),
      surfaces_(settings.bounces + 1),
      points_(settings.seed),
      offsets_(points_.makeOffsets(device)),
      camera_(scene.camera),
      paths_(device.gl(), form == PathForm::loop ? "loop" : "unrolled",
             composeVertexShader(traversalNamed(settings.traversal).gles),
             composePathProbe(effectsOf(scene), settings.traversal, pathText(surfaces_, form))),
      accumulation_(device) {}

void WholePathTracer::resize(int width, int height) {
  radiance_ = gl::Target(gl::Texture::floats(device_->gl(), device_->floatForm(), width, height));
  accumulation_.resize(width, height);
  samples_ = 0;
}

void WholePathTracer::drawSample() {
  drawPaths();
  accumulation_.add(radiance_.texture(), {0, 0, radiance_.width(), radiance_.height()});
  accumulation_.endSample();
  ++samples_;
}

void WholePathTracer::bindSamplePoints() {
  const auto bind = [this](const std::string& point, const std::string& shift, std::uint32_t set) {
    paths_.set(point, points_.point(samples_, set));
    paths_.set(shift, points_.offsetsShift(set));
  };
  bind("uPoint", "uOffsetsShift", raySet(0));
  for (int i = 0; i < surfaces_; ++i) {
    bind(fmt::format("uLightPoints[{}]", i), fmt::format("uLightShifts[{}]", i), lightSet(i));
    bind(fmt::format("uScatterPoints[{}]", i), fmt::format("uScatterShifts[{}]", i), raySet(i + 1));
  }
  paths_.set("uOffsets", offsets_);
}

void WholePathTracer::use(gl::Program& program) const {
  program.use();
  program.set("uZero", Vec4(0));
  program.set("uPictureStep", 1.0f / Vec2(radiance_.width(), radiance_.height()));
}

void WholePathTracer::drawPaths() {
  const int width = radiance_.width();
  const int height = radiance_.height();
  use(paths_);
  textures_->bind(paths_);
  bindSamplePoints();
  bindCamera(paths_, camera_, width, height);
  radiance_.bind();
  device_->draw({0, 0, width, height});
}

}  // namespace glimt
