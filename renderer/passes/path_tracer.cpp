#include "renderer/passes/path_tracer.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "renderer/passes/camera_uniforms.h"
#include "renderer/scene/effects_of.h"

namespace glimt {
namespace {

// Tiles begin at multiples of this many pixels, which is how tiled rasterisers divide a target.
constexpr int kTileStep = 64;

// Whether a hit record is of a path that has met a triangle; see shaders/hit_record.glsl, whose
// first channel holds the triangle in its mantissa.
bool isHit(const Vec4& record) {
  constexpr std::uint32_t kMantissa = (1u << 23) - 1;
  constexpr std::uint32_t kUnknown = kMantissa - 1;
  return record.x != 0 && (std::bit_cast<std::uint32_t>(record.x) & kMantissa) < kUnknown;
}

}  // namespace

PathTracer::PathTracer(const gl::Device& device, const Scene& scene,
                       const PathTracerSettings& settings)
    : PathTracer(device, scene, settings, buildSceneTree(scene)) {}

PathTracer::PathTracer(const gl::Device& device, const Scene& scene,
                       const PathTracerSettings& settings, const SceneTree& tree)
    : device_(&device),
      points_(settings.seed),
      traversal_(chooseTraversal(settings.traversal, tree.bvh, device.info().software)),
      scene_(device, scene, tree, traversalNamed(traversal_).layout),
      offsets_(points_.makeOffsets(device)),
      camera_(scene.camera) {
  compile(scene);
  for (int bounce = 0; bounce <= settings.bounces; ++bounce) {
    stages_.push_back({bounce == 0 ? Pass::camera : Pass::trace, bounce});
    stages_.push_back({Pass::light, bounce});
  }
  stages_.push_back({Pass::accumulate, 0});
}

void PathTracer::compile(const Scene& scene) {
  const auto start = std::chrono::steady_clock::now();
  const std::string vertex = composeVertexShader();
  for (const Pass pass : {Pass::camera, Pass::trace, Pass::light, Pass::accumulate}) {
    const ShaderRequest request{pass, effectsOf(scene), traversal_, device_->floatBlending()};
    programs_.emplace(
        pass, gl::Program(device_->gl(), nameOf(pass), vertex, composeFragmentShader(request)));
  }
  compile_seconds_ =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void PathTracer::setCamera(const Camera& camera) {
  camera_ = camera;
  restart();
}

void PathTracer::resize(int width, int height) {
  if (width == film_.width() && height == film_.height()) return;
  film_ = Film(*device_, width, height);
  restart();
}

void PathTracer::restart() {
  film_.mean.clear();
  samples_ = 0;
  stage_ = 0;
  row_ = 0;
  column_ = 0;
}

double PathTracer::drawTile(double pixels) {
  const Stage stage = stages_[stage_];
  if (row_ == 0 && column_ == 0) beginStage(stage);
  const gl::Tile tile = nextTile(pixels);
  drawStage(stage, tile);
  column_ += tile.width;
  if (column_ == film_.width()) {
    column_ = 0;
    row_ += tile.height;
  }
  if (row_ == film_.height()) {
    row_ = 0;
    endStage(stage);
    stage_ = (stage_ + 1) % stages_.size();
    if (stage_ == 0) ++samples_;
  }
  return static_cast<double>(tile.width) * tile.height;
}

// As many whole rows as there may be pixels, or a part of the least number of rows.
gl::Tile PathTracer::nextTile(double pixels) const {
  const auto steps = [](double n) {
    return kTileStep * std::max(1, static_cast<int>(n / kTileStep));
  };
  const bool whole_rows = column_ == 0 && pixels >= static_cast<double>(film_.width()) * kTileStep;
  const int rows = whole_rows ? steps(pixels / film_.width()) : kTileStep;
  const int columns = whole_rows ? film_.width() : steps(pixels / kTileStep);
  return {column_, row_, std::min(columns, film_.width() - column_),
          std::min(rows, film_.height() - row_)};
}

void PathTracer::beginStage(const Stage& stage) {
  if (stage.pass == Pass::camera) film_.radiance.clear();
}

void PathTracer::drawStage(const Stage& stage, const gl::Tile& tile) {
  gl::Program& program = this->program(stage.pass);
  program.use();
  program.set("uZero", Vec4(0));
  program.set("uPictureStep", 1.0f / Vec2(film_.width(), film_.height()));
  if (stage.pass == Pass::accumulate) {
    program.set("uRadiance", film_.radiance.front().texture());
    program.set("uMean", film_.mean.front().texture());
    film_.mean.back().bind();
    device_->draw(tile);
    return;
  }
  scene_.bind(program);
  bindSamplePoint(program, stage);
  program.set("uRecord", film_.record.front().texture());
  if (stage.pass != Pass::light) {
    bindCamera(program, camera_, film_.width(), film_.height());
    film_.record.back().bind();
    device_->draw(tile);
    return;
  }
  program.set("uLastSurface", stage.bounce == stages_[stages_.size() - 2].bounce ? 1.0f : 0.0f);
  if (device_->floatBlending()) {
    film_.radiance.front().bind();
    device_->drawAdding(tile);
  } else {
    program.set("uRadiance", film_.radiance.front().texture());
    film_.radiance.back().bind();
    device_->draw(tile);
  }
}

void PathTracer::endStage(const Stage& stage) {
  if (stage.pass == Pass::accumulate) {
    film_.mean.swap();
  } else if (stage.pass == Pass::light) {
    if (!device_->floatBlending()) film_.radiance.swap();
  } else {
    film_.record.swap();
    if (!rays_counted_) countRays(stage);
  }
}

void PathTracer::countRays(const Stage& stage) {
  const std::vector<Vec4> records = film_.record.front().readFloats();
  const auto hits = static_cast<double>(std::count_if(records.begin(), records.end(), isHit));
  const bool last = stage.bounce == stages_[stages_.size() - 2].bounce;
  if (stage.pass == Pass::camera) rays_ = {static_cast<double>(records.size()), 0, 0};
  if (!last) rays_.bounce += hits;
  rays_.shadow += hits;
  rays_counted_ = last;
}

void PathTracer::bindSamplePoint(gl::Program& program, const Stage& stage) const {
  const std::uint32_t set =
      stage.pass == Pass::light ? lightSet(stage.bounce) : raySet(stage.bounce);
  program.set("uPoint", points_.point(static_cast<std::uint32_t>(samples_), set));
  program.set("uOffsetsShift", points_.offsetsShift(set));
  program.set("uOffsets", offsets_);
}

}  // namespace glimt
