#include "renderer/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <type_traits>

#include "renderer/core/error.h"
#include "renderer/core/wording.h"
#include "renderer/gl/context.h"
#include "renderer/gl/errors.h"
#include "renderer/gl/float_target.h"
#include "renderer/passes/denoiser.h"
#include "renderer/passes/noise_meter.h"
#include "renderer/passes/path_tracer.h"
#include "renderer/passes/scene_tree.h"
#include "renderer/passes/traversal_trial.h"
#include "renderer/probes/loop_turns.h"
#include "renderer/read_back.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

// A draw is cut so that it takes about this long: short enough for a window to answer, long enough
// that starting it costs nothing.
constexpr double kDrawSeconds = 0.03;

// Keeps the arithmetic sound where a clock is coarse.
constexpr double kLeastSecondsPerPixel = 1e-11;

// Of any device. What a smaller one holds is found out when the scene is handed over.
constexpr int kLargestTexture = 32768;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// One loop over all triangles has to come to its end. Trees need far fewer turns than they have
// triangles, how many is not known beforehand.
void checkLoops(const gl::Device& device, const std::string& traversal, std::size_t triangles) {
  if (traversal != "linear") return;
  constexpr std::size_t kSteps = MAX_STEPS;
  const auto wanted = static_cast<std::uint32_t>(std::min(triangles, kSteps));
  const std::uint32_t turns = LoopProbe(device).turns(wanted);
  if (turns >= triangles) return;
  throw Error(
      ErrorKind::input,
      fmt::format("traversal 'linear' takes one loop turn per triangle, of which the scene "
                  "has {}, and {} ends loops after {}; use --traversal auto",
                  grouped(triangles), turns < wanted ? "this driver" : "it", grouped(turns)));
}

// The device, once it is known to do for the scene.
gl::Device deviceFor(gl::Context& context, const std::string& traversal, std::size_t triangles) {
  gl::Device device(context);
  checkLoops(device, traversal, triangles);
  return device;
}

PathTracerSettings tracerSettings(const RenderSettings& settings) {
  PathTracerSettings out{settings.bounces, settings.seed,    settings.traversal,
                         settings.record,  settings.sampler, settings.clamp};
  out.roulette = settings.roulette;
  out.first_sample = settings.first_sample;
  out.squares = settings.keep_spread;
  out.path_lengths = settings.keep_path_lengths;
  return out;
}

gl::Texture zeroTexel(const gl::Device& device) {
  return gl::Texture::floats(device.gl(), device.floatForm(), 1, 1, {Vec4(0)});
}

std::array<double, kPassCount> filled(double value) {
  std::array<double, kPassCount> values;
  values.fill(value);
  return values;
}

}  // namespace

class Renderer::State {
 public:
  // Without a tree it makes one.
  State(gl::Context& context, const Scene& scene, const RenderSettings& settings, const Tree* given,
        const WorkProgress& progress)
      : device(deviceFor(context, settings.traversal, scene.triangles.size())),
        tree(given ? given->shared()
                   : std::make_shared<const SceneTree>(
                         buildSceneTree(scene, device.maxTextureSize(), progress))),
        tracer(device, scene, tracerSettings(settings), *tree, progress),
        trial(tracer.candidates()),
        noise(device),
        denoiser_(device) {
    tracer.resize(settings.width, settings.height);
    restart();
  }

  // Draws a tile, and learns from the time it took how large the next of its pass may be.
  void drawTile() {
    double& cost = seconds_per_pixel_[static_cast<std::size_t>(tracer.nextPass())];
    const double start = now();
    const double pixels = drawChecked(kDrawSeconds / cost);
    const double seconds = now() - start;
    sample_seconds_ += seconds;
    // Half of the last: later bounces of the same pass have fewer paths, and the next sample begins
    // with all of them.
    cost = std::max({seconds / pixels, 0.5 * cost, kLeastSecondsPerPixel});
    if (tracer.atSampleStart()) endSample();
  }

  // Another picture begins.
  void restart() {
    trial.restart();
    tracer.use(trial.traversal());
    sample_seconds_ = 0;
    noise.restart(tracer.film().width(), tracer.film().height(), tracer.sampler());
    denoiser_.restart();
  }

  const gl::Target& denoise(const WorkProgress& progress) {
    while (tracer.samples() == 0 || !tracer.atSampleStart()) drawTile();
    return watched([&]() -> const gl::Target& { return denoiser_.denoise(tracer, progress); });
  }

  // Null where the samples themselves are shown.
  const gl::Target* denoisedFor(Shown shown) {
    return shown == Shown::denoised ? &denoise({}) : nullptr;
  }

  void drawDisplay(const gl::Target* denoised, int width, int height, float exposure, Tone tone) {
    if (!display_ || tone_ != tone) {
      ShaderRequest request;
      request.pass = Pass::display;
      request.tone = tone;
      display_.emplace(device.gl(), nameOf(Pass::display), composeVertexShader(),
                       composeFragmentShader(request));
      tone_ = tone;
    }
    display_->use();
    display_->set("uZero", Vec4(0));
    tracer.accumulation().bind(*display_);
    if (denoised) {
      if (no_block_.width() == 0) no_block_ = zeroTexel(device);
      display_->set("uMean", denoised->texture());
      display_->set("uBlock", no_block_);
    }
    display_->set("uDisplaySize", Vec2(width, height));
    display_->set("uExposureScale", std::exp2(exposure));
    device.draw({0, 0, width, height});
  }

  // After a draw has failed. A lost context takes every call and does nothing, and not every driver
  // says so: what shows is that it cannot draw either.
  void demandReadable() const {
    if (!failed_ || tryFloatTarget(device.gl(), device.floatForm()) == gl::FloatTarget::exact)
      return;
    throw Error(ErrorKind::failed, "the picture cannot be read back from a context that is lost");
  }

  std::optional<NoiseEstimate> noiseWhenDue() {
    return watched([&] { return noise.measureWhenDue(tracer.accumulation(), tracer.samples()); });
  }
  std::optional<NoiseEstimate> noiseNow() {
    return watched([&] { return noise.measure(tracer.accumulation(), tracer.samples()); });
  }

  gl::Device device;
  std::shared_ptr<const SceneTree> tree;
  PathTracer tracer;
  TraversalTrial trial;
  NoiseMeter noise;

 private:
  // Remembers that a draw has failed.
  template <typename Draws>
  std::invoke_result_t<Draws> watched(const Draws& draws) {
    try {
      return draws();
    } catch (const Error&) {
      failed_ = true;
      throw;
    }
  }

  void endSample() {
    trial.add(sample_seconds_);
    tracer.use(trial.traversal());
    sample_seconds_ = 0;
    watched([&] {
      if (noise.endSample(tracer.accumulation(), tracer.samples(), tracer.census().lengths()))
        tracer.rest(noise.rest().tiles());
    });
  }

  // A sample that the failing draw completed is not complete.
  double drawChecked(double most_pixels) {
    const int before = tracer.samples();
    try {
      return watched([&] {
        const double pixels = tracer.drawTile(most_pixels);
        device.gl().Finish();
        gl::checkErrors(device.gl(), "finishing a draw");
        return pixels;
      });
    } catch (const Error&) {
      if (tracer.samples() > before) tracer.takeBackSample();
      throw;
    }
  }

  Denoiser denoiser_;
  gl::Texture no_block_;  // stands for the block of a picture that has none
  std::optional<gl::Program> display_;
  Tone tone_ = Tone::srgb;  // of that program
  bool failed_ = false;
  // For each pass; at first a guess that is slow enough.
  std::array<double, kPassCount> seconds_per_pixel_ = filled(kDrawSeconds / 16384);
  double sample_seconds_ = 0;  // spent on the sample that is being drawn
};

Tree::Tree(const Scene& scene, const WorkProgress& progress)
    : tree_(std::make_shared<SceneTree>(buildSceneTree(scene, kLargestTexture, progress))) {}

Renderer::Renderer(ContextHandle& context, const Scene& scene, const RenderSettings& settings,
                   const WorkProgress& progress)
    : state_(std::make_unique<State>(context.get(), scene, settings, nullptr, progress)) {}
Renderer::Renderer(ContextHandle& context, const Scene& scene, const Tree& tree,
                   const RenderSettings& settings, const WorkProgress& progress)
    : state_(std::make_unique<State>(context.get(), scene, settings, &tree, progress)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

void Renderer::setMaterials(const Scene& scene, MaterialChange change) {
  if (change == MaterialChange::numbers) {
    state_->tracer.setNumbers(scene, *state_->tree);
  } else {
    if (!isOver(*state_->tree, scene))
      throw Error(ErrorKind::usage,
                  "the triangles are not where they were; make another renderer for this scene");
    state_->tracer.setMaterials(scene, *state_->tree);
  }
  state_->restart();
}

void Renderer::setCamera(const Camera& camera) {
  state_->tracer.setCamera(camera);
  state_->restart();
}

void Renderer::resize(int width, int height) {
  state_->tracer.resize(width, height);
  state_->restart();
}

void Renderer::setLimits(const LightLimits& limits) {
  state_->tracer.setLimits(limits);
  state_->restart();
}

void Renderer::setSampler(Sampler sampler, std::uint32_t seed) {
  state_->tracer.setSampler(sampler, seed);
  state_->restart();
}

void Renderer::restBelow(std::optional<double> goal) {
  state_->noise.restBelow(state_->tracer.canRest() ? goal : std::nullopt);
}

void Renderer::renderSample() {
  const int before = samples();
  while (samples() == before) state_->drawTile();
}

void Renderer::advance(double seconds, int most_samples) {
  const double end = now() + seconds;
  while (samples() < most_samples) {
    state_->drawTile();
    if (now() >= end) break;
  }
}

int Renderer::samples() const {
  return state_->tracer.samples();
}

Picture Renderer::picture() {
  state_->demandReadable();
  return readPicture(state_->tracer, state_->noise.rest());
}

std::optional<NoiseEstimate> Renderer::noise() {
  return state_->noiseWhenDue();
}

std::optional<NoiseEstimate> Renderer::noiseNow() {
  return state_->noiseNow();
}

Image Renderer::radiance() {
  return picture().radiance;
}

Image Renderer::denoised(const WorkProgress& progress) {
  const gl::Target& denoised = state_->denoise(progress);
  return readDenoised(radiance(), denoised);
}

FirstHits Renderer::firstHits(int rays) {
  while (!state_->tracer.atSampleStart()) state_->drawTile();
  return readFirstHits(state_->tracer, rays);
}

int Renderer::nonfinitePixels() {
  return picture().nonfinite_pixels;
}

Losses Renderer::lastLosses() {
  return readLosses(state_->tracer, state_->noise.rest());
}

std::optional<std::uint32_t> Renderer::loopLimit() {
  constexpr std::uint32_t kMost = 1u << 18;
  return findLoopLimit(state_->device, kMost);
}

DisplayImage Renderer::display(float exposure, Tone tone, Shown shown) {
  const Film& film = state_->tracer.film();
  const gl::Target* const denoised = state_->denoisedFor(shown);
  const gl::Target target(gl::Texture::bytes(state_->device.gl(), film.width(), film.height()));
  target.bind();
  state_->drawDisplay(denoised, film.width(), film.height(), exposure, tone);
  DisplayImage image = readDisplay(target);
  image.denoised = denoised != nullptr;
  return image;
}

void Renderer::present(int framebuffer_width, int framebuffer_height, float exposure, Tone tone,
                       Shown shown) {
  const gl::Functions& gl = state_->device.gl();
  const gl::Target* const denoised = state_->denoisedFor(shown);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Viewport(0, 0, framebuffer_width, framebuffer_height);
  state_->drawDisplay(denoised, framebuffer_width, framebuffer_height, exposure, tone);
}

std::map<std::string, std::string> Renderer::shaders() const {
  return state_->tracer.shaders();
}

RenderStatistics Renderer::statistics() const {
  const PathTracer& tracer = state_->tracer;
  RenderStatistics statistics;
  statistics.traversal = tracer.traversal();
  statistics.traversal_times = state_->trial.times();
  statistics.triangles = state_->tree->bvh.order.size();
  statistics.nodes = tracer.scene().nodeCount();
  statistics.texture_bytes = tracer.scene().bytes();
  statistics.warnings = tracer.scene().warnings();
  statistics.bvh_seconds = tracer.scene().buildSeconds();
  statistics.compile_seconds = tracer.compileSeconds();
  statistics.camera_rays = tracer.census().rays().camera;
  statistics.bounce_rays = tracer.census().rays().bounce;
  statistics.shadow_rays = tracer.census().rays().shadow;
  statistics.noise_seconds = state_->noise.seconds();
  return statistics;
}

}  // namespace glimt
