#include "renderer/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <type_traits>

#include "renderer/core/error.h"
#include "renderer/core/luminance.h"
#include "renderer/core/wording.h"
#include "renderer/gl/context.h"
#include "renderer/gl/errors.h"
#include "renderer/gl/float_target.h"
#include "renderer/passes/noise_meter.h"
#include "renderer/passes/path_tracer.h"
#include "renderer/passes/scene_tree.h"
#include "renderer/passes/traversal_trial.h"
#include "renderer/probes/loop_turns.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

// A draw is cut so that it takes about this long: short enough for a window to answer, long enough
// that starting it costs nothing.
constexpr double kDrawSeconds = 0.03;

// Keeps the arithmetic sound where a clock is coarse.
constexpr double kLeastSecondsPerPixel = 1e-11;

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
  out.first_sample = settings.first_sample;
  out.squares = settings.keep_spread;
  out.path_lengths = settings.keep_path_lengths;
  return out;
}

// Rows from the top, of those that GL has from the bottom.
template <typename Value, typename ValueOf>
std::vector<Value> fromTop(const std::vector<Vec4>& texels, const Film& film,
                           const ValueOf& valueOf) {
  std::vector<Value> values;
  values.reserve(texels.size());
  for (int y = film.height() - 1; y >= 0; --y)
    for (int x = 0; x < film.width(); ++x)
      values.push_back(valueOf(texels[static_cast<std::size_t>(y) * film.width() + x]));
  return values;
}

// What covers a pixel: surfaces and, where there are none, the shadow on a catcher.
float alphaOf(const Vec4& seen) {
  const float shadow = seen.z > 0 ? 1 - seen.y / seen.z : 0;
  return std::clamp(seen.x + (1 - seen.x) * shadow, 0.0f, 1.0f);
}

std::array<double, kPassCount> filled(double value) {
  std::array<double, kPassCount> values;
  values.fill(value);
  return values;
}

}  // namespace

class Renderer::State {
 public:
  State(gl::Context& context, const Scene& scene, const RenderSettings& settings,
        const WorkProgress& progress)
      : device(deviceFor(context, settings.traversal, scene.triangles.size())),
        tree(buildSceneTree(scene, device.maxTextureSize(), progress)),
        tracer(device, scene, tracerSettings(settings), tree, progress),
        trial(tracer.candidates()),
        noise(device) {
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
    noise.restart(tracer.film().width(), tracer.film().height());
  }

  void drawDisplay(int width, int height, float exposure, Tone tone) {
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

  // How many samples a pixel has to have by now, y from the bottom.
  int samplesAt(int x, int y) const {
    const int at_rest = noise.rest().samplesAt(x, y);
    return at_rest > 0 ? at_rest : tracer.samples();
  }

  std::optional<NoiseEstimate> noiseWhenDue() {
    return watched([&] { return noise.measureWhenDue(tracer.accumulation(), tracer.samples()); });
  }
  std::optional<NoiseEstimate> noiseNow() {
    return watched([&] { return noise.measure(tracer.accumulation(), tracer.samples()); });
  }

  // What is kept of the pixels beside the mean, whose texels these are.
  void addKept(Picture& picture, const std::vector<Vec4>& means) const {
    const Film& film = tracer.film();
    picture.pixel_samples = fromTop<float>(means, film, [](const Vec4& mean) { return mean.a; });
    if (const Accumulation* const coverage = tracer.kept(Accumulated::coverage))
      picture.radiance.alpha = fromTop<float>(coverage->readMean(), film, alphaOf);
    if (const Accumulation* const lengths = tracer.kept(Accumulated::path_length))
      picture.path_lengths =
          fromTop<float>(lengths->readMean(), film, [](const Vec4& mean) { return mean.x; });
    const Accumulation* const squares = tracer.kept(Accumulated::square);
    if (squares == nullptr) return;
    picture.spread =
        fromTop<float>(squares->readMean(), film, [](const Vec4& mean) { return mean.x; });
    for (std::size_t i = 0; i < picture.spread.size(); ++i) {
      const double light = luminance(picture.radiance.pixels[i]);
      const double variance = picture.spread[i] - light * light;
      picture.spread[i] = static_cast<float>(std::sqrt(std::max(variance, 0.0)));
    }
  }

  gl::Device device;
  SceneTree tree;
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
      if (noise.endSample(tracer.accumulation(), tracer.samples(), tracer.lengths()))
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

  std::optional<gl::Program> display_;
  Tone tone_ = Tone::srgb;  // of that program
  bool failed_ = false;
  // For each pass; at first a guess that is slow enough.
  std::array<double, kPassCount> seconds_per_pixel_ = filled(kDrawSeconds / 16384);
  double sample_seconds_ = 0;  // spent on the sample that is being drawn
};

Renderer::Renderer(ContextHandle& context, const Scene& scene, const RenderSettings& settings,
                   const WorkProgress& progress)
    : state_(std::make_unique<State>(context.get(), scene, settings, progress)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

void Renderer::setMaterials(const Scene& scene) {
  if (!isOver(state_->tree, scene))
    throw Error(ErrorKind::usage,
                "the triangles are not where they were; make another renderer for this scene");
  state_->tracer.setMaterials(scene, state_->tree);
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
  const Film& film = state_->tracer.film();
  const std::vector<Vec4> texels = state_->tracer.accumulation().readMean();
  Picture picture{{film.width(), film.height(), {}}, samples(), 0, 0};
  picture.mean_samples = state_->noise.rest().meanSamples(picture.samples);
  Image& image = picture.radiance;
  image.pixels.reserve(texels.size());
  for (int y = image.height - 1; y >= 0; --y)  // GL's rows begin at the bottom
    for (int x = 0; x < image.width; ++x) {
      const Vec4& texel = texels[static_cast<std::size_t>(y) * image.width + x];
      image.pixels.emplace_back(texel);
      picture.nonfinite_pixels += texel.a < static_cast<float>(state_->samplesAt(x, y));
    }
  state_->addKept(picture, texels);
  return picture;
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

FirstHits Renderer::firstHits(int rays) {
  PathTracer& tracer = state_->tracer;
  while (!tracer.atSampleStart()) state_->drawTile();
  const Film& film = tracer.film();
  const Camera& camera = tracer.camera();
  const Vec3 forward = CameraFrame(camera).forward;
  const auto count = static_cast<std::size_t>(film.width()) * film.height();
  FirstHits hits{std::vector<Vec3>(count),
                 std::vector<Vec3>(count),
                 std::vector<float>(count),
                 {},
                 std::vector<float>(count)};
  const auto texelsOf = [&](int ray, int wanted) {
    return fromTop<Vec4>(tracer.firstHits(ray, wanted), film, [](const Vec4& v) { return v; });
  };
  for (int ray = 0; ray < rays; ++ray) {
    const std::vector<Vec4> albedo = texelsOf(ray, 0);
    const std::vector<Vec4> normal = texelsOf(ray, 1);
    const std::vector<Vec4> place = texelsOf(ray, 2);
    for (std::size_t i = 0; i < count; ++i) {
      if (ray == 0) hits.material.push_back(place[i].a);
      if (!(albedo[i].a > 0)) continue;
      hits.coverage[i] += 1;
      hits.albedo[i] += Vec3(albedo[i]);
      hits.normal[i] += Vec3(normal[i]);
      hits.depth[i] += glm::dot(Vec3(place[i]) - camera.position, forward);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const float met = std::max(hits.coverage[i], 1.0f);
    hits.albedo[i] /= met;
    hits.normal[i] /= met;
    hits.depth[i] /= met;
    hits.coverage[i] /= static_cast<float>(rays);
  }
  return hits;
}

int Renderer::nonfinitePixels() {
  return picture().nonfinite_pixels;
}

Losses Renderer::lastLosses() {
  Losses losses;
  const int width = state_->tracer.film().width();
  const std::vector<Vec4> texels = state_->tracer.film().radiance.front().readFloats();
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const auto at = static_cast<int>(i);
    if (state_->noise.rest().samplesAt(at % width, at / width) > 0) continue;
    // As light.glsl marks them, and as sample_mean.glsl asks.
    const Vec4& texel = texels[i];
    const bool marked = std::min({texel.r, texel.g, texel.b}) < 0;
    const bool good = texel.r + texel.g + texel.b <= 1e30f;
    losses.cut_short += marked;
    losses.not_finite += !marked && !good;
  }
  return losses;
}

std::optional<std::uint32_t> Renderer::loopLimit() {
  constexpr std::uint32_t kMost = 1u << 18;
  return findLoopLimit(state_->device, kMost);
}

DisplayImage Renderer::display(float exposure, Tone tone) {
  const Film& film = state_->tracer.film();
  const gl::Target target(gl::Texture::bytes(state_->device.gl(), film.width(), film.height()));
  target.bind();
  state_->drawDisplay(film.width(), film.height(), exposure, tone);
  const std::vector<unsigned char> bytes = target.readBytes();
  DisplayImage image{film.width(), film.height(), {}};
  image.bytes.reserve(bytes.size() / 4 * 3);
  for (int y = image.height - 1; y >= 0; --y)
    for (int x = 0; x < image.width; ++x)
      for (int channel = 0; channel < 3; ++channel)
        image.bytes.push_back(bytes[(static_cast<std::size_t>(y) * image.width + x) * 4 + channel]);
  return image;
}

void Renderer::present(int framebuffer_width, int framebuffer_height, float exposure, Tone tone) {
  const gl::Functions& gl = state_->device.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Viewport(0, 0, framebuffer_width, framebuffer_height);
  state_->drawDisplay(framebuffer_width, framebuffer_height, exposure, tone);
}

std::map<std::string, std::string> Renderer::shaders() const {
  return state_->tracer.shaders();
}

RenderStatistics Renderer::statistics() const {
  const PathTracer& tracer = state_->tracer;
  RenderStatistics statistics;
  statistics.traversal = tracer.traversal();
  statistics.traversal_times = state_->trial.times();
  statistics.triangles = state_->tree.bvh.order.size();
  statistics.nodes = tracer.scene().nodeCount();
  statistics.texture_bytes = tracer.scene().bytes();
  statistics.warnings = tracer.scene().warnings();
  statistics.bvh_seconds = tracer.scene().buildSeconds();
  statistics.compile_seconds = tracer.compileSeconds();
  statistics.camera_rays = tracer.rays().camera;
  statistics.bounce_rays = tracer.rays().bounce;
  statistics.shadow_rays = tracer.rays().shadow;
  statistics.noise_seconds = state_->noise.seconds();
  return statistics;
}

}  // namespace glimt
