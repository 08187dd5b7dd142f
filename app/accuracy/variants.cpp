#include "app/accuracy/variants.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/scene/effects_of.h"
#include "renderer/scene/texture_image.h"

namespace glimt {
namespace {

class Variants {
 public:
  Variants(const Scene& scene, const RenderSettings& settings, int gles) : scene_(scene) {
    base_.settings = settings;
    base_.gles = gles;
    add(base_);
    addBounces();
    addSampler();
    addRecord();
    addTextures();
    addEnvironmentTable();
    addTraversals();
    addClamps();
  }

  std::vector<AccuracyVariant> take() { return std::move(variants_); }

 private:
  void add(const AccuracyVariant& variant) { variants_.push_back(variant); }

  AccuracyVariant turned(const std::string& knob, const std::string& value,
                         const std::string& options) const {
    AccuracyVariant variant = base_;
    variant.knob = knob;
    variant.value = value;
    variant.options = options;
    return variant;
  }

  void addBounces() {
    const int own = base_.settings.bounces;
    for (const int bounces : {own / 2, own - 1, own + 2, 2 * own, 4 * own}) {
      if (bounces < 1 || bounces == own || bounces > kMostBounces) continue;
      if (variants_.back().settings.bounces == bounces) continue;
      AccuracyVariant variant =
          turned("bounces", fmt::format("{}", bounces), fmt::format("--bounces {}", bounces));
      variant.settings.bounces = bounces;
      add(variant);
    }
  }

  void addSampler() {
    const bool random = base_.settings.sampler == Sampler::random;
    const std::string name(kSamplerNames[random ? 0 : 1]);
    AccuracyVariant variant = turned("sampler", name, "--sampler " + name);
    variant.settings.sampler = random ? Sampler::sobol : Sampler::random;
    add(variant);
  }

  void addRecord() {
    if (base_.settings.record == "wide") return;
    AccuracyVariant variant = turned("record", "wide", "--gles 3 --record wide");
    variant.settings.record = "wide";
    variant.gles = 3;
    add(variant);
  }

  void addTextures() {
    if (scene_.images.empty()) return;
    for (const int halvings : {1, 2}) {
      AccuracyVariant variant = turned("textures", fmt::format("1/{}", 1 << halvings), "");
      variant.texture_halvings = halvings;
      add(variant);
    }
  }

  void addEnvironmentTable() {
    if (!has(effectsOf(scene_), Effect::environment_map)) return;
    for (const std::size_t cells : {std::size_t{1} << 13, std::size_t{1} << 7}) {
      AccuracyVariant variant = turned("environment table", fmt::format("{}", cells), "");
      variant.environment_cells = cells;
      add(variant);
    }
  }

  // The picture is the same; what differs is the time.
  void addTraversals() {
    for (const char* traversal : {"octant-ahead", "octant", "stack"}) {
      AccuracyVariant variant =
          turned("traversal", traversal, fmt::format("--traversal {}", traversal));
      variant.settings.traversal = traversal;
      add(variant);
    }
  }

  void addClamps() {
    for (const float clamp : {10.0f, 2.0f}) {
      AccuracyVariant variant =
          turned("clamp", fmt::format("{}", clamp), fmt::format("--clamp {}", clamp));
      variant.settings.clamp = clamp;
      add(variant);
    }
  }

  const Scene& scene_;
  AccuracyVariant base_;
  std::vector<AccuracyVariant> variants_;
};

}  // namespace

std::vector<AccuracyVariant> accuracyVariants(const Scene& scene, const RenderSettings& settings,
                                              int gles) {
  return Variants(scene, settings, gles).take();
}

bool shareRenderer(const AccuracyVariant& a, const AccuracyVariant& b) {
  return a.gles == b.gles && a.settings.traversal == b.settings.traversal &&
         a.settings.record == b.settings.record && a.texture_halvings == b.texture_halvings &&
         a.environment_cells == b.environment_cells &&
         a.settings.clamp.has_value() == b.settings.clamp.has_value();
}

Scene sceneOf(const AccuracyVariant& variant, const Scene& scene) {
  Scene turned = scene;
  for (int i = 0; i < variant.texture_halvings; ++i)
    for (TextureImage& image : turned.images) image = halved(image);
  turned.environment.most_cells = variant.environment_cells;
  return turned;
}

}  // namespace glimt
