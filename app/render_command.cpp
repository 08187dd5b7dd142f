#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>

#include "app/auxiliary_layers.h"
#include "app/commands.h"
#include "app/forecast.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "app/output_files.h"
#include "app/picture_files.h"
#include "app/picture_inputs.h"
#include "app/progress.h"
#include "app/render_report.h"
#include "app/sampling.h"
#include "app/share/share.h"
#include "app/stopwatch.h"
#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/image_file.h"
#include "renderer/core/image_layers.h"
#include "renderer/core/sha256.h"
#include "renderer/core/wording.h"
#include "renderer/scene/effects_of.h"
#include "renderer/scene/load_scene.h"

namespace glimt {
namespace {

// A forecast is made after at least so many samples, and then after so many seconds or samples.
constexpr int kLeastForForecast = 16;
constexpr int kMostForForecast = 64;
constexpr double kSecondsForForecast = 10;

// How long to look for what the limits leave out: a small part of the time, where there is much.
double limitSeconds(double render_seconds) {
  return std::clamp(0.02 * render_seconds, 0.05, 5.0);
}

std::string failureOf(const Sampling& sampling) {
  const int saved = sampling.picture.samples;
  const std::string later = sampling.samples > saved
                                ? fmt::format(", without the last {}", sampling.samples - saved)
                                : "";
  return fmt::format("{}; the picture so far is saved, {}{}", sampling.failure,
                     counted(static_cast<std::uintmax_t>(saved), "sample"), later);
}

class RenderCommand {
 public:
  explicit RenderCommand(const RenderOptions& options)
      : options_(options), progress_(!options.quiet) {}

  void run();

 private:
  void checkOutputs() const;
  Scene load();
  void writeShaders(const Renderer& renderer) const;
  Renderer makeRenderer(ContextHandle& context, const Scene& scene);
  Limits limits() const;
  Sampling render(Renderer& renderer);
  Sampling sampleFor(Renderer& renderer);
  std::string lossesOf(Renderer& renderer) const;
  void measureLimits(Renderer& renderer);
  RenderSettings settingsFor(const Scene& scene) const;
  Image denoised(const Sampling& sampling, Renderer& renderer);
  ImageLayers layersFor(const Sampling& sampling, const Image& shown, const Scene& scene,
                        Renderer& renderer);
  void writePictures(const Sampling& sampling, const Scene& scene, Renderer& renderer);
  void warn(const std::string& what);
  void endIfInterrupted() const;

  const RenderOptions& options_;
  Stopwatch clock_;
  std::optional<Interrupt> interrupt_;
  Progress progress_;
  RenderReport report_;
};

void RenderCommand::run() {
  checkOutputs();
  const Scene scene = load();
  report_.settings = settingsFor(scene);
  // Until here, where there is nothing to be saved, a signal may end the program as it does any.
  interrupt_.emplace();

  progress_.show("starting GL");
  ContextHandle context = createOffscreenContext(options_.backend, options_.picture.gles);
  report_.context = context.info();
  endIfInterrupted();
  Renderer renderer = makeRenderer(context, scene);
  for (const std::string& warning : renderer.statistics().warnings) warn(warning);
  if (!options_.even) renderer.restBelow(options_.noise);
  if (!options_.shader_folder.empty()) writeShaders(renderer);
  const Sampling sampling = render(renderer);

  writePictures(sampling, scene, renderer);
  report_.total = clock_.seconds();
  if (sampling.ended_by != EndedBy::interrupt && sampling.failure.empty()) measureLimits(renderer);
  writeJson(options_.json, jsonOf(report_));
  if (!sampling.failure.empty()) throw Error(ErrorKind::failed, failureOf(sampling));
  if (!report_.forecast.empty() && options_.json != "-") writeOut(textOf(report_.forecast));
  if (!options_.quiet && !report_.outputs.empty()) sayPlain(summaryOf(report_));
}

// What does not fit into the device is wrong with the scene's file, as far as its user goes.
Renderer RenderCommand::makeRenderer(ContextHandle& context, const Scene& scene) {
  progress_.show("building the tree");
  try {
    return Renderer(context, scene, report_.settings, [this](float fraction) {
      endIfInterrupted();
      showTree(progress_, fraction);
    });
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input) throw;
    throw Error(ErrorKind::input,
                fmt::format("{}: {}", printable(options_.scene.string()), error.what()));
  }
}

RenderSettings RenderCommand::settingsFor(const Scene& scene) const {
  RenderSettings settings = settingsOf(options_.picture, scene);
  if (options_.share && scene.transparent_background)
    throw Error(ErrorKind::usage,
                "shares of a picture with a transparent background cannot be merged; leave out "
                "--samples or the background");
  if (options_.share) settings.first_sample = options_.share->first;
  settings.keep_spread = options_.share.has_value() || options_.denoise;
  keepFor(options_.layers, settings);
  if (settings.keep_path_lengths && scene.transparent_background)
    throw Error(ErrorKind::usage,
                "the cost is not known over a transparent background; ask for other --layers");
  return settings;
}

void RenderCommand::writeShaders(const Renderer& renderer) const {
  makeFolder(options_.shader_folder);
  for (const auto& [pass, text] : renderer.shaders())
    writeFile(options_.shader_folder / (pass + ".frag"), text);
}

void RenderCommand::checkOutputs() const {
  for (const auto& output : options_.outputs) {
    const bool exr = imageFormatOf(output) == ImageFormat::exr;
    if (options_.share && !exr)
      throw Error(ErrorKind::usage,
                  fmt::format("{}: a share of the samples is written as .exr, for glimt merge",
                              printable(output.string())));
    if (options_.denoise) checkCanTellDenoised(output);
    checkWritable(output);
  }
  checkJsonFile(options_.json);
}

Scene RenderCommand::load() {
  progress_.show(fmt::format("loading {}", options_.scene.string()));
  Scene scene = loadScene(options_.scene, {options_.load.variant, options_.picture.environment,
                                           options_.picture.transparent_background});
  scene.camera = cameraOf(options_.picture.camera, scene);
  report_.scene = options_.scene;
  report_.outputs = options_.outputs;
  for (const EffectReport& effect : reportEffects(scene)) {
    if (effect.on) report_.effects.push_back(effect.name);
  }
  report_.load = clock_.seconds();
  for (const std::string& warning : scene.warnings) warn(warning);
  return scene;
}

Limits RenderCommand::limits() const {
  Limits limits{options_.samples, options_.seconds, options_.noise};
  if (options_.share) limits.samples = options_.share->count;
  return orDefault(limits);
}

Sampling RenderCommand::sampleFor(Renderer& renderer) {
  if (!options_.forecast) return sampleUntil(renderer, limits(), *interrupt_, progress_);
  const Sampling least = sampleUntil(renderer, {kLeastForForecast, {}, {}}, *interrupt_, progress_);
  if (least.ended_by != EndedBy::samples || least.seconds >= kSecondsForForecast) return least;
  Sampling sampling =
      sampleUntil(renderer, {kMostForForecast, kSecondsForForecast - least.seconds, {}},
                  *interrupt_, progress_);
  sampling.seconds += least.seconds;
  sampling.first_sample = least.first_sample;
  return sampling;
}

Sampling RenderCommand::render(Renderer& renderer) {
  const double before = clock_.seconds();
  Sampling sampling = sampleFor(renderer);
  progress_.clear();
  if (sampling.samples == 0) endIfInterrupted();

  report_.statistics = renderer.statistics();
  report_.samples = sampling.picture.samples;
  report_.mean_samples = sampling.picture.mean_samples;
  report_.first_sample = before + sampling.first_sample;
  report_.render = sampling.seconds;
  report_.nonfinite_pixels = sampling.picture.nonfinite_pixels;
  report_.noise = sampling.noise;
  report_.noise_goal = options_.noise;
  report_.ended_by = sampling.ended_by;
  if (options_.forecast && sampling.noise)
    report_.forecast = forecast(*sampling.noise, sampling.seconds / sampling.samples, before);
  if (sampling.ended_by == EndedBy::interrupt)
    warn("interrupted after " + counted(report_.samples, "sample"));
  if (!sampling.failure.empty()) {
    report_.warnings.push_back(failureOf(sampling));
  } else if (report_.nonfinite_pixels > 0) {
    warn(lossesOf(renderer));
  }
  return sampling;
}

// The driver's loop limit is measured only where it may be what cut rays short.
std::string RenderCommand::lossesOf(Renderer& renderer) const {
  Losses last;
  std::optional<std::uint32_t> loop_limit;
  try {
    last = renderer.lastLosses();
    const bool by_values = last.not_finite > 0 && last.cut_short == 0;
    if (!by_values) loop_limit = renderer.loopLimit();
  } catch (const Error&) {  // GL fails, but the picture is there already
  }
  return warningOf(report_.nonfinite_pixels, last, loop_limit);
}

// The pictures are there already.
void RenderCommand::measureLimits(Renderer& renderer) {
  if (!report_.noise || (options_.quiet && options_.json.empty())) return;
  progress_.show("measuring what the limits leave out");
  try {
    report_.limits = glimt::measureLimits(renderer, report_.settings, report_.noise->relative,
                                          limitSeconds(report_.render));
  } catch (const Error& error) {
    warn(fmt::format("what the limits leave out is not known: {}", error.what()));
  }
  progress_.clear();
  report_.measure_limits = clock_.seconds() - report_.total;
}

// The picture as it is to be seen. Where it cannot be denoised it is what its samples are.
Image RenderCommand::denoised(const Sampling& sampling, Renderer& renderer) {
  if (!options_.denoise) return sampling.picture.radiance;
  const Stopwatch clock;
  try {
    if (!sampling.failure.empty()) throw Error(ErrorKind::failed, "GL has failed before");
    interrupt_->forget();
    Image image = renderer.denoised([this](float fraction) {
      if (interrupt_->requested()) throw Error(ErrorKind::failed, "interrupted");
      if (progress_.due()) progress_.show(fmt::format("denoising, {}", percent(fraction)));
    });
    progress_.clear();
    report_.denoised = true;
    report_.denoise = clock.seconds();
    return image;
  } catch (const Error& error) {
    warn(fmt::format("the picture is not denoised: {}", error.what()));
    return sampling.picture.radiance;
  }
}

// All that an .exr holds. What GL fails in is left out, and told.
ImageLayers RenderCommand::layersFor(const Sampling& sampling, const Image& shown,
                                     const Scene& scene, Renderer& renderer) {
  const Picture& picture = sampling.picture;
  ImageLayers layers = layersOf(shown);
  if (options_.share)
    layers = layersOf(Share{{{options_.share->first, picture.samples}},
                            sha256Of(inputsOf(scene, report_.settings).dump()),
                            picture.radiance,
                            picture.pixel_samples,
                            picture.spread});
  if (options_.layers.empty() || !sampling.failure.empty()) return layers;
  if (shown.denoised) addUndenoised(layers, picture.radiance);
  try {
    addAuxiliaryLayers(layers, options_.layers, picture, renderer);
  } catch (const Error& error) {
    warn(fmt::format("there are not all layers: {}", error.what()));
  }
  return layers;
}

// A file that cannot be written does not keep the others from being written.
void RenderCommand::writePictures(const Sampling& sampling, const Scene& scene,
                                  Renderer& renderer) {
  const Image shown = denoised(sampling, renderer);
  const float exposure = exposureOf(options_.picture, scene);
  const Tone tone = toneOf(options_.picture, scene);
  std::exception_ptr first_error;
  for (const auto& output : options_.outputs) {
    try {
      if (imageFormatOf(output) == ImageFormat::exr)
        writeLayers(output, layersFor(sampling, shown, scene, renderer));
      else
        writePicture(output, shown, exposure, tone);
    } catch (const Error&) {
      if (!first_error) first_error = std::current_exception();
    }
  }
  if (first_error) std::rethrow_exception(first_error);
}

void RenderCommand::warn(const std::string& what) {
  report_.warnings.push_back(what);
  if (options_.quiet) return;
  progress_.clear();
  say("warning: " + what);
}

void RenderCommand::endIfInterrupted() const {
  if (!interrupt_->requested()) return;
  throw Error(ErrorKind::failed, "interrupted before the first sample; nothing was written");
}

}  // namespace

int runRender(const RenderOptions& options) {
  RenderCommand(options).run();
  return 0;
}

}  // namespace glimt
