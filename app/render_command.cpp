#include <fmt/format.h>

#include <exception>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "app/output_files.h"
#include "app/progress.h"
#include "app/render_report.h"
#include "app/sampling.h"
#include "app/stopwatch.h"
#include "renderer/core/error.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"
#include "renderer/scene/effects_of.h"
#include "renderer/scene/load_scene.h"

namespace glimt {
namespace {

constexpr int kDefaultSamples = 256;

class RenderCommand {
 public:
  explicit RenderCommand(const RenderOptions& options)
      : options_(options), progress_(!options.quiet) {}

  void run();

 private:
  void checkOutputs() const;
  Scene load();
  void render(Renderer& renderer);
  std::string lossesOf(Renderer& renderer) const;
  void writePictures(Renderer& renderer, float exposure) const;
  void warn(const std::string& what);
  void endIfInterrupted() const;

  const RenderOptions& options_;
  Stopwatch clock_;
  Interrupt interrupt_;
  Progress progress_;
  RenderReport report_;
};

void RenderCommand::run() {
  checkOutputs();
  const Scene scene = load();
  report_.settings = settingsOf(options_.picture, scene);
  endIfInterrupted();

  progress_.show("starting GL");
  ContextHandle context = createOffscreenContext(options_.backend, options_.picture.gles);
  report_.context = context.info();
  progress_.show("building the tree");
  Renderer renderer(context, scene, report_.settings, [this](float fraction) {
    endIfInterrupted();
    showTree(progress_, fraction);
  });
  render(renderer);

  writePictures(renderer, exposureOf(options_.picture, scene));
  report_.total = clock_.seconds();
  writeJson(options_.json, jsonOf(report_));
  if (!options_.quiet) sayPlain(summaryOf(report_));
}

void RenderCommand::checkOutputs() const {
  for (const auto& output : options_.outputs) {
    imageFormatOf(output);
    checkWritable(output);
  }
  checkJsonFile(options_.json);
}

Scene RenderCommand::load() {
  progress_.show(fmt::format("loading {}", options_.scene.string()));
  Scene scene = loadScene(options_.scene);
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

void RenderCommand::render(Renderer& renderer) {
  Limits limits{options_.samples, options_.seconds};
  if (!limits.samples && !limits.seconds) limits.samples = kDefaultSamples;
  const double before = clock_.seconds();
  const Sampling sampling = sampleUntil(renderer, limits, interrupt_, progress_);
  progress_.clear();
  if (sampling.samples == 0) endIfInterrupted();

  report_.statistics = renderer.statistics();
  report_.samples = sampling.samples;
  report_.first_sample = before + sampling.first_sample;
  report_.render = sampling.seconds;
  report_.nonfinite_pixels = renderer.nonfinitePixels();
  if (sampling.interrupted) warn("interrupted after " + counted(report_.samples, "sample"));
  if (report_.nonfinite_pixels > 0) warn(lossesOf(renderer));
}

// The driver's loop limit is measured only where it may be what cut rays short.
std::string RenderCommand::lossesOf(Renderer& renderer) const {
  const Losses last = renderer.lastLosses();
  const bool by_values = last.not_finite > 0 && last.cut_short == 0;
  const auto loop_limit = by_values ? std::nullopt : renderer.loopLimit();
  return warningOf(report_.nonfinite_pixels, last, loop_limit);
}

// A file that cannot be written does not keep the others from being written.
void RenderCommand::writePictures(Renderer& renderer, float exposure) const {
  std::exception_ptr first_error;
  for (const auto& output : options_.outputs) {
    try {
      if (imageFormatOf(output) == ImageFormat::png) {
        writeDisplayImage(output, renderer.display(exposure));
      } else {
        writeImage(output, renderer.radiance());
      }
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
  if (!interrupt_.requested()) return;
  throw Error(ErrorKind::failed, "interrupted before the first sample; nothing was written");
}

}  // namespace

int runRender(const RenderOptions& options) {
  RenderCommand(options).run();
  return 0;
}

}  // namespace glimt
