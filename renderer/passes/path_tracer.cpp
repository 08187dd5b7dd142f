#include "renderer/passes/path_tracer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "renderer/core/error.h"
#include "renderer/gl/errors.h"
#include "renderer/passes/camera_uniforms.h"
#include "renderer/passes/data_texture.h"
#include "renderer/scene/effects_of.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

// Tiles begin at multiples of this many pixels, which is how tiled rasterisers divide a target.
constexpr int kTileStep = 64;

// Whether any path is alive is asked where the first sample had fewer of them left: the answer has
// to be waited for.
constexpr double kFewAlive = 0.01;

// Weak paths may end from this bounce on. Behind the first surface the light of a dark one is all
// that its pixel has.
constexpr int kFirstRoulette = 2;

// No sample that is finite is brighter.
constexpr float kNeverClamped = 1e30f;

// Whether there may be directions as dense as PDF_SHARP of shaders/bsdf_sample.glsl.
bool reflectsSharply(const EffectSet& effects) {
  return has(effects, Effect::mirror) || has(effects, Effect::gloss) ||
         has(effects, Effect::glass) || has(effects, Effect::rough_glass) ||
         has(effects, Effect::clearcoat);
}

Record recordFor(const gl::Device& device, const std::string& name) {
  const Record& record = recordNamed(name);
  const bool several = record.samplers.size() > 1;
  if (record.gles > device.info().gles || (several && !device.gl().DrawBuffers))
    throw Error(ErrorKind::usage, fmt::format("record '{}' needs OpenGL ES {}.0; render with "
                                              "--gles {}",
                                              name, record.gles, record.gles));
  return record;
}

}  // namespace

PathTracer::PathTracer(const gl::Device& device, const Scene& scene,
                       const PathTracerSettings& settings, const WorkProgress& progress)
    : PathTracer(device, scene, settings, buildSceneTree(scene, device.maxTextureSize(), progress),
                 progress) {}

PathTracer::PathTracer(const gl::Device& device, const Scene& scene,
                       const PathTracerSettings& settings, const SceneTree& tree,
                       const WorkProgress& progress)
    : device_(&device),
      points_(settings.seed, settings.sampler),
      candidates_(candidateTraversals(settings.traversal, tree.bvh, device.info(),
                                      mostTexels(device.maxTextureSize()))),
      traversal_(candidates_.front()),
      record_(recordFor(device, settings.record)),
      first_sample_(static_cast<std::uint32_t>(settings.first_sample)),
      path_lengths_(settings.path_lengths),
      scene_(device, scene, tree, traversalNamed(traversal_).layout, settings.change),
      offsets_(points_.makeOffsets(device)),
      change_(settings.change),
      effects_(changed(effectsOf(scene), change_)),
      bounces_(settings.bounces),
      roulette_(settings.roulette),
      live_only_(settings.live_only && canDrawLiveOnly(device)),
      accumulations_(device, settings.clamp, has(effects_, Effect::transparent_background),
                     settings.squares, settings.path_lengths),
      camera_(scene.camera),
      query_(device.gl()) {
  planStages();
  compile(progress);
}

void PathTracer::planStages() {
  stages_.clear();
  for (int bounce = 0; bounce <= bounces_; ++bounce) planBounce(bounce);
  // Light samples find nothing for a mirror, and little for what is nearly one, so at the last
  // surface a ray looks for it.
  if (reflectsSharply(effects_)) planBounce(bounces_ + 1);
  stages_.push_back({Pass::accumulate, 0});
  if ((samples_ + 1) % SAMPLES_PER_BLOCK == 0) stages_.push_back({Pass::close_block, 0});
}

void PathTracer::planBounce(int bounce) {
  stages_.push_back({bounce == 0 ? Pass::camera : Pass::trace, bounce});
  if (has(effects_, Effect::environment) || marksEnded(bounce))
    stages_.push_back({Pass::escape, bounce});
  stages_.push_back({Pass::light, bounce});
}

// Marking ended paths costs a draw and spares those that follow from them. It pays after the
// camera, where it is the background, and where the first sample left less than half of the picture
// alive.
bool PathTracer::marksEnded(int bounce) const {
  if (!live_only_) return false;
  if (bounce == 0 || bounce > bounces_) return true;
  return census_.complete() && census_.alive(bounce) < 0.5;
}

PathTracer::ProgramKey PathTracer::keyOf(Pass pass) const {
  const bool traces = pass == Pass::camera || pass == Pass::trace || pass == Pass::light ||
                      pass == Pass::first_hit || pass == Pass::delta;
  EffectSet effects = effects_;
  if (pass != Pass::camera) effects = withCamera(effects, Camera());
  return {traces ? traversal_ : "", pass, effects.to_ulong()};
}

ShaderRequest PathTracer::requestFor(Pass pass) const {
  ShaderRequest request;
  request.pass = pass;
  request.effects = effects_;
  request.traversal = traversal_;
  request.record = record_.name;
  request.additive_blending = device_->floatBlending();
  request.live_only = live_only_;
  request.path_length = path_lengths_;
  request.gles = std::max(traversalNamed(traversal_).gles, record_.gles);
  return request;
}

std::map<std::string, std::string> PathTracer::shaders() const {
  std::map<std::string, std::string> texts;
  for (const Stage& stage : stages_)
    texts[nameOf(stage.pass)] = composeFragmentShader(requestFor(stage.pass));
  return texts;
}

void PathTracer::compile(const WorkProgress& progress) {
  const auto start = std::chrono::steady_clock::now();
  for (const Stage& stage : stages_) {
    const bool accumulates = stage.pass == Pass::accumulate || stage.pass == Pass::close_block;
    if (accumulates || programs_.contains(keyOf(stage.pass))) continue;
    if (progress) progress(1);
    compilePass(stage.pass);
  }
  compile_seconds_ +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void PathTracer::compilePass(Pass pass) {
  const ShaderRequest request = requestFor(pass);
  programs_.emplace(keyOf(pass), gl::Program(device_->gl(), nameOf(pass),
                                             composeVertexShader(requestFor(Pass::camera).gles),
                                             composeFragmentShader(request)));
}

void PathTracer::use(const std::string& traversal) {
  if (traversal == traversal_) return;
  traversal_ = traversal;
  compile({});
}

void PathTracer::setMaterials(const Scene& scene, const SceneTree& tree) {
  SceneTextures textures(*device_, scene, tree, traversalNamed(traversal_).layout, change_);
  takeEffects(scene);
  scene_ = std::move(textures);
}

void PathTracer::setNumbers(const Scene& scene, const SceneTree& tree) {
  SceneTextures::Surfaces surfaces = scene_.surfacesOf(*device_, scene, tree, change_);
  takeEffects(scene);
  scene_.take(std::move(surfaces), scene.environment);
}

// Begins again with the programs that the scene calls for; where one does not compile, with those
// that were.
void PathTracer::takeEffects(const Scene& scene) {
  const EffectSet before = std::exchange(effects_, changed(effectsOf(scene), change_));
  census_.forget();
  try {
    restart();
    compile({});
  } catch (const Error&) {
    effects_ = before;
    restart();
    throw;
  }
  accumulations_.setTransparent(has(effects_, Effect::transparent_background));
  camera_ = scene.camera;
}

void PathTracer::setCamera(const Camera& camera) {
  camera_ = camera;
  effects_ = changed(withCamera(effects_, camera), change_);
  compile({});
  restart();
}

void PathTracer::resize(int width, int height) {
  if (width == film_.width() && height == film_.height()) return;
  film_ = Film(*device_, width, height, record_.samplers.size());
  accumulations_.resize(width, height);
  restart();
}

void PathTracer::setLimits(const LightLimits& limits) {
  bounces_ = limits.bounces;
  accumulations_.setClamp(limits.clamp.value_or(kNeverClamped));
  census_.forget();
  restart();
  compile({});  // the first bounce, where there was none
}

void PathTracer::setSampler(Sampler sampler, std::uint32_t seed) {
  points_ = SamplePoints(seed, sampler);
  offsets_ = points_.makeOffsets(*device_);
  restart();
}

void PathTracer::restart() {
  resting_.clear();
  accumulations_.clear();
  samples_ = 0;
  planStages();
  stage_ = 0;
  row_ = 0;
  column_ = 0;
}

double PathTracer::drawTile(double pixels) {
  const Stage stage = stages_[stage_];
  if (row_ == 0 && column_ == 0) beginStage(stage);
  const gl::Tile tile = nextTile(pixels);
  gl::clearErrors(device_->gl());
  drawStage(stage, tile);
  gl::checkErrors(device_->gl(), "drawing the pass " + nameOf(stage.pass));
  column_ += tile.width;
  if (column_ == film_.width()) {
    column_ = 0;
    row_ += tile.height;
  }
  if (row_ == film_.height()) {
    row_ = 0;
    endStage(stage);
    stage_ = stageAfter();
    if (stage_ == 0) {
      ++samples_;
      planStages();
    }
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

// Where no path is alive what is left of the sample is to add it to the picture.
std::size_t PathTracer::stageAfter() const {
  const auto adds = [](const Stage& stage) { return stage.pass == Pass::accumulate; };
  const auto sum = std::find_if(stages_.begin(), stages_.end(), adds) - stages_.begin();
  const auto next = stage_ + 1;
  return alive_now_ ? next % stages_.size() : std::max(next, static_cast<std::size_t>(sum));
}

void PathTracer::takeBackSample() {
  --samples_;
}

// Ended paths are marked behind a bounce that few survive, see marksEnded().
bool PathTracer::asksWhetherAlive(const Stage& stage) const {
  return stage.pass == Pass::trace && live_only_ && query_ && census_.complete() &&
         census_.alive(stage.bounce - 1) < kFewAlive;
}

void PathTracer::beginStage(const Stage& stage) {
  alive_now_ = !asksWhetherAlive(stage);
  if (stage.pass == Pass::camera) beginSample();
  // Pixels that are left out keep the record of an earlier bounce, which only counting would read.
  if (stage.pass == Pass::trace && live_only_ && !census_.complete()) film_.record.back().clear();
}

// Pixels at rest are as those whose path has ended, and their radiance is one that does not count.
void PathTracer::beginSample() {
  constexpr Vec4 kNoSample(-1, -1, -1, 0);
  film_.radiance.clear();
  if (!live_only_) return;
  const gl::Target& radiance = film_.radiance.front();
  radiance.clearStencil();
  for (const gl::Tile& tile : resting_) {
    radiance.clear(tile, kNoSample);
    radiance.mark(tile);
  }
}

void PathTracer::drawStage(const Stage& stage, const gl::Tile& tile) {
  if (stage.pass == Pass::accumulate) {
    accumulations_.add(film_.radiance.front().texture(), tile);
    return;
  }
  if (stage.pass == Pass::close_block) {
    accumulations_.closeBlock(tile);
    return;
  }
  gl::Program& program = this->program(stage.pass);
  bindPath(program, stage, first_sample_ + static_cast<std::uint32_t>(samples_));
  program.set("uFromCamera", isOfCamera(stage) ? 1.0f : 0.0f);
  gl::DrawState state;
  if (live_only_)
    state.limit = stage.pass == Pass::escape ? gl::Limit::unmarked_then_mark : gl::Limit::unmarked;
  if (stage.pass == Pass::camera || stage.pass == Pass::trace) {
    bindCamera(program, camera_, film_.width(), film_.height());
    program.set("uSharpOnly", stage.bounce > bounces_ ? 1.0f : 0.0f);
    program.set("uRoulette", roulette_ && stage.bounce >= kFirstRoulette ? 1.0f : 0.0f);
    film_.record.back().bind();
    drawRays(tile, state);
    return;
  }
  program.set("uLastSurface", static_cast<float>(std::max(stage.bounce - bounces_ + 1, 0)));
  if (device_->floatBlending()) {
    state.adding = true;
    film_.radiance.front().bind();
  } else {
    program.set("uRadiance", film_.radiance.front().texture());
    film_.radiance.back().bind();
  }
  device_->draw(tile, state);
}

// What every pass of a path asks for.
void PathTracer::bindPath(gl::Program& program, const Stage& stage, std::uint32_t sample) const {
  program.use();
  program.set("uZero", Vec4(0));
  program.set("uPictureStep", 1.0f / Vec2(film_.width(), film_.height()));
  scene_.bind(program);
  bindSamplePoint(program, stage, sample);
  for (std::size_t i = 0; i < record_.samplers.size(); ++i)
    program.set(record_.samplers[i], film_.record.front().texture(i));
}

// Whether the record that the stage reads is that of the camera's ray.
bool PathTracer::isOfCamera(const Stage& stage) {
  return stage.bounce == (stage.pass == Pass::trace ? 1 : 0);
}

// One tile with a living path is enough to know.
void PathTracer::drawRays(const gl::Tile& tile, const gl::DrawState& state) {
  if (alive_now_) {
    device_->draw(tile, state);
    return;
  }
  query_.begin();
  device_->draw(tile, state);
  query_.end();
  alive_now_ = query_.anyPassed();
}

void PathTracer::endStage(const Stage& stage) {
  if (stage.pass == Pass::accumulate) {
    accumulations_.endSample();
  } else if (stage.pass == Pass::close_block) {
    // Before the block is forgotten it has to be part of the mean.
    device_->gl().Finish();
    gl::checkErrors(device_->gl(), "closing a block of samples");
    accumulations_.endBlock();
  } else if (stage.pass == Pass::escape || stage.pass == Pass::light) {
    if (!device_->floatBlending()) film_.radiance.swap();
    if (stage.pass == Pass::light && census_.endsEarly(bounces_)) alive_now_ = false;
  } else {
    film_.record.swap();
    if (!census_.complete())
      census_.count(film_.record.front().readFloats(), record_.name, stage.bounce, bounces_);
  }
}

void PathTracer::bindSamplePoint(gl::Program& program, const Stage& stage,
                                 std::uint32_t sample) const {
  const std::uint32_t set =
      stage.pass == Pass::light ? lightSet(stage.bounce) : raySet(stage.bounce);
  points_.bindPoints(program, "uPoint", sample, set);
  program.set("uOffsetsShift", points_.offsetsShift(set));
  program.set("uOffsets", offsets_);
  if (stage.pass != Pass::camera) return;
  points_.bindPoints(program, "uLensPoint", sample, kLensSet);
  program.set("uLensOffsetsShift", points_.offsetsShift(kLensSet));
}

}  // namespace glimt
