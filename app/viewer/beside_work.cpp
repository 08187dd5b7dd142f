#include "app/viewer/beside_work.h"

#include <algorithm>
#include <cmath>

#include "renderer/bench.h"
#include "renderer/core/image_file.h"

namespace glimt {
namespace {

// How long a cancelled render goes on.
constexpr double kChunk = 0.1;

constexpr double kLimitSeconds = 2;

// Of the pictures that tell what effects cost: a sixteenth of the window's pixels is enough, and
// shows what the window does.
constexpr double kCostScale = 0.25;
constexpr int kCostRepeats = 7;

Scene sceneOf(const BesidePicture& picture) {
  Scene scene = picture.view.scene->scene;
  apply(picture.view.look, scene);
  scene.camera = picture.camera;
  return scene;
}

RenderSettings settingsOf(const BesidePicture& picture) {
  RenderSettings settings = picture.settings;
  settings.bounces = picture.view.look.bounces;
  return settings;
}

}  // namespace

void renderToFile(const BesidePicture& picture, int samples, const std::filesystem::path& file,
                  const WorkProgress& progress) {
  const ImageFormat format = imageFormatOf(file);
  ContextHandle context = createOffscreenContext(Backend::automatic, picture.gles);
  Renderer renderer(context, sceneOf(picture), picture.view.scene->tree, settingsOf(picture));
  while (renderer.samples() < samples) {
    renderer.advance(kChunk, samples);
    progress(static_cast<float>(renderer.samples()) / static_cast<float>(samples));
  }
  const Look& look = picture.view.look;
  if (format == ImageFormat::png)
    writeDisplayImage(file, renderer.display(look.exposure, look.tone));
  else
    writeImage(file, renderer.radiance());
}

LimitError measureLimitsOf(const BesidePicture& picture, double noise,
                           const WorkProgress& progress) {
  ContextHandle context = createOffscreenContext(Backend::automatic, picture.gles);
  Renderer renderer(context, sceneOf(picture), picture.view.scene->tree, settingsOf(picture));
  progress(0.5f);
  return measureLimits(renderer, settingsOf(picture), noise, kLimitSeconds);
}

EffectCosts effectCostsOf(const BesidePicture& picture, const WorkProgress& progress) {
  const RenderSettings& settings = picture.settings;
  EffectsBenchSettings bench;
  bench.bounces = picture.view.look.bounces;
  const double pixels = static_cast<double>(settings.width) * settings.height;
  bench.side = std::max(static_cast<int>(std::lround(kCostScale * std::sqrt(pixels))), 16);
  bench.repeats = kCostRepeats;
  bench.compile_repeats = 1;
  bench.forced = false;
  ContextHandle context = createOffscreenContext(Backend::automatic, picture.gles);
  EffectCosts costs;
  for (const EffectsRow& row :
       benchEffects(context, sceneOf(picture), picture.view.scene->tree, bench,
                    [&progress](const std::string&) { progress(0.5f); })) {
    if (row.withheld.empty() || !row.ratio) continue;
    costs[row.effect.substr(std::string(kWithheld).size())] = 1 - row.ratio->median;
  }
  return costs;
}

}  // namespace glimt
