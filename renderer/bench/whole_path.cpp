#include "renderer/bench/whole_path.h"

#include <fmt/format.h>

#include "renderer/passes/camera_uniforms.h"
#include "renderer/scene/effects_of.h"
#include "renderer/shader/composer.h"
#include "renderer/shader/traversals.h"

namespace glimt {
namespace {

// Points of the light samples at each surface, and of the directions in which paths leave it.
constexpr const char* kPoints =
    "uniform vec4 uLightPoints[POINT_GROUPS * SURFACES];\n"
    "uniform vec4 uLightShifts[SURFACES];\n"
    "uniform vec4 uScatterPoints[POINT_GROUPS * SURFACES];\n"
    "uniform vec4 uScatterShifts[SURFACES];\n"
    "#define OWN(points, i) ownPoint(pixel, points[4 * (i)], points[4 * (i) + 1], "
    "points[4 * (i) + 2], points[4 * (i) + 3])\n"
    "#define POINT(points, shifts, i) shiftedPoint(pixel, OWN(points, i), shifts[i])\n";

constexpr const char* kLoopBody = R"(
  for (int i = 0; i < SURFACES; i++) {
    meetSurface(path, POINT(uLightPoints, uLightShifts, i), i == 0, i == SURFACES - 1);
    if (path.ended || i == SURFACES - 1) break;
    scatterPath(path, POINT(uScatterPoints, uScatterShifts, i));
  }
)";

std::string unrolledBody(int surfaces) {
  std::string text;
  for (int i = 0; i < surfaces; ++i) {
    const bool last = i == surfaces - 1;
    text += fmt::format("  meetSurface(path, POINT(uLightPoints, uLightShifts, {}), {}, {});\n", i,
                        i == 0, last);
    if (!last)
      text += fmt::format("  scatterPath(path, POINT(uScatterPoints, uScatterShifts, {}));\n", i);
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
      accumulation_(device, settings.clamp) {}

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
  const auto bind = [this](const char* points, int i, const char* shifts, std::uint32_t set) {
    points_.bindPoints(paths_, points, samples_, set, static_cast<std::uint32_t>(i));
    paths_.set(fmt::format("{}[{}]", shifts, i), points_.offsetsShift(set));
  };
  points_.bindPoints(paths_, "uPoint", samples_, raySet(0));
  paths_.set("uOffsetsShift", points_.offsetsShift(raySet(0)));
  for (int i = 0; i < surfaces_; ++i) {
    bind("uLightPoints", i, "uLightShifts", lightSet(i));
    bind("uScatterPoints", i, "uScatterShifts", raySet(i + 1));
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
