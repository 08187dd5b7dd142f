#include "app/auxiliary_layers.h"

#include <algorithm>
#include <cmath>

namespace glimt {
namespace {

// Edges are as smooth with these as eyes can tell.
constexpr int kRays = 32;

bool wants(const std::vector<std::string>& wanted, const char* name) {
  return std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

// Standard deviation of each pixel's mean luminance, if its samples were independent.
std::vector<float> noiseOf(const Picture& picture) {
  std::vector<float> noise = picture.spread;
  for (std::size_t i = 0; i < noise.size(); ++i)
    noise[i] /= std::sqrt(std::max(picture.pixel_samples[i], 1.0f));
  return noise;
}

void addVectors(ImageLayers& layers, const std::string& name, const char* axes,
                const std::vector<Vec3>& vectors) {
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float>& channel = layers.channels[name + "." + axes[axis]];
    channel.reserve(vectors.size());
    for (const Vec3& vector : vectors) channel.push_back(vector[axis]);
  }
}

}  // namespace

void keepFor(const std::vector<std::string>& wanted, RenderSettings& settings) {
  settings.keep_spread = settings.keep_spread || wants(wanted, "noise");
  settings.keep_path_lengths = wants(wanted, "cost");
}

void addUndenoised(ImageLayers& layers, const Image& picture) {
  addVectors(layers, "undenoised", "RGB", picture.pixels);
}

void addAuxiliaryLayers(ImageLayers& layers, const std::vector<std::string>& wanted,
                        const Picture& picture, Renderer& renderer) {
  if (wants(wanted, "noise")) layers.channels["noise"] = noiseOf(picture);
  if (wants(wanted, "cost")) layers.channels["cost"] = picture.path_lengths;
  const bool of_hits = std::any_of(wanted.begin(), wanted.end(), [](const std::string& name) {
    return name != "noise" && name != "cost";
  });
  if (!of_hits) return;
  const FirstHits hits = renderer.firstHits(kRays);
  if (wants(wanted, "albedo")) addVectors(layers, "albedo", "RGB", hits.albedo);
  if (wants(wanted, "normal")) addVectors(layers, "normal", "XYZ", hits.normal);
  if (wants(wanted, "depth")) layers.channels["depth.Z"] = hits.depth;
  if (wants(wanted, "material")) layers.channels["material"] = hits.material;
}

}  // namespace glimt
