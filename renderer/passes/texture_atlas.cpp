#include "renderer/passes/texture_atlas.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/core/wording.h"
#include "renderer/scene/texture_image.h"
#include "renderer/scene/texture_uses.h"

namespace glimt {
namespace {

constexpr std::uint64_t kMostBytes = 1u << 30;

// Of the pictures that are looked up; the others are 0 wide.
std::vector<AtlasRectangle> sizesOf(const Scene& scene) {
  std::vector<AtlasRectangle> sizes(scene.images.size());
  for (const Material& material : scene.materials) {
    const auto uses = usesOf(material);
    for (const TextureUse* use : uses) {
      if (!use->used()) continue;
      const TextureImage& image = scene.images[use->image];
      sizes[use->image] = {0, 0, image.width, image.height};
    }
  }
  return sizes;
}

std::vector<std::string> warningsOf(const Scene& scene, const AtlasPlan& plan) {
  std::vector<std::string> scaled;
  for (std::size_t i = 0; i < plan.halvings.size(); ++i) {
    if (plan.halvings[i] == 0) continue;
    const TextureImage& image = scene.images[i];
    scaled.push_back(fmt::format("{} from {}x{} to {}x{}", image.name, image.width, image.height,
                                 plan.rectangles[i].width, plan.rectangles[i].height));
  }
  if (scaled.empty()) return {};
  return {
      fmt::format("textures made smaller to fit into one of this device's: {}", listed(scaled))};
}

void copyInto(std::vector<std::uint8_t>& texels, int width, const TextureImage& image,
              const AtlasRectangle& place) {
  const auto row = static_cast<std::size_t>(image.width) * 4;
  for (int y = 0; y < image.height; ++y) {
    const std::size_t to =
        (static_cast<std::size_t>(place.y + y) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(place.x)) *
        4;
    std::copy_n(image.rgba.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * row),
                row, texels.begin() + static_cast<std::ptrdiff_t>(to));
  }
}

std::vector<std::uint8_t> texelsOf(const Scene& scene, const AtlasPlan& plan) {
  std::vector<std::uint8_t> texels(static_cast<std::size_t>(plan.width) *
                                   static_cast<std::size_t>(plan.height) * 4);
  for (std::size_t i = 0; i < plan.rectangles.size(); ++i) {
    if (plan.rectangles[i].width == 0) continue;
    if (plan.halvings[i] == 0) {
      copyInto(texels, plan.width, scene.images[i], plan.rectangles[i]);
      continue;
    }
    TextureImage smaller = halved(scene.images[i]);
    for (int n = 1; n < plan.halvings[i]; ++n) smaller = halved(smaller);
    copyInto(texels, plan.width, smaller, plan.rectangles[i]);
  }
  return texels;
}

}  // namespace

TextureAtlas::TextureAtlas(const gl::Device& device, const Scene& scene)
    : plan_(planAtlas(sizesOf(scene), device.maxTextureSize(), kMostBytes)),
      warnings_(warningsOf(scene, plan_)) {
  texture_ = plan_.width == 0 ? gl::Texture::bytes(device.gl(), 1, 1)
                              : gl::Texture::bytes(device.gl(), plan_.width, plan_.height,
                                                   texelsOf(scene, plan_));
}

void TextureAtlas::bind(gl::Program& program) const {
  program.set("uAtlas", texture_);
  program.set("uAtlasStep", 1.0f / Vec2(texture_.width(), texture_.height()));
}

std::size_t TextureAtlas::bytes() const {
  return static_cast<std::size_t>(plan_.width) * static_cast<std::size_t>(plan_.height) * 4;
}

}  // namespace glimt
