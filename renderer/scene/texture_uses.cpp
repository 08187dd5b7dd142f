#include "renderer/scene/texture_uses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/core/srgb.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

bool isWhole(const TextureImage& image) {
  return image.width > 0 && image.height > 0 &&
         image.rgba.size() ==
             4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

bool isFinite(const TextureUse& use) {
  return std::isfinite(use.offset.x + use.offset.y + use.scale.x + use.scale.y + use.rotation);
}

// What is not a number becomes `low`.
float within(float value, float low, float high) {
  return value >= low ? std::min(value, high) : low;
}

void checkUses(Scene& scene) {
  std::vector<std::string> flawed;
  for (Material& material : scene.materials) {
    bool dropped = false;
    for (TextureUse* use : usesOf(material)) {
      if (!use->used()) continue;
      const bool good = use->image < scene.images.size() && isWhole(scene.images[use->image]) &&
                        isFinite(*use) && (use->texcoords == 0 || use->texcoords == 1);
      if (good) continue;
      use->image = kNoIndex;
      dropped = true;
    }
    if (dropped) flawed.push_back(material.name);
    material.alpha = within(material.alpha, 0, 1);
    material.alpha_cutoff = within(material.alpha_cutoff, 0, 2);
    if (!std::isfinite(material.normal_scale)) material.normal_scale = 1;
  }
  if (flawed.empty()) return;
  scene.warnings.push_back(
      fmt::format("textures left out that cannot be looked up, of {}", listed(flawed)));
}

// Triangles lose an attribute of which a vertex has none.
void checkIndices(Scene& scene) {
  const auto missing = [](const std::array<std::uint32_t, 3>& indices, std::size_t count) {
    return std::any_of(indices.begin(), indices.end(),
                       [count](std::uint32_t index) { return index >= count; });
  };
  for (Triangle& triangle : scene.triangles) {
    if (missing(triangle.texcoords, scene.texcoords.size())) triangle.texcoords.fill(kNoIndex);
    if (missing(triangle.colors, scene.colors.size())) triangle.colors.fill(kNoIndex);
  }
}

void checkAttributes(Scene& scene) {
  // Beyond, floats do not tell the texels of a picture apart.
  constexpr float kFarthest = 1e6f;
  std::size_t flawed = 0;
  for (TexCoords& texcoords : scene.texcoords) {
    bool good = true;
    for (const Vec2& at : texcoords.sets)
      good = good && std::abs(at.x) <= kFarthest && std::abs(at.y) <= kFarthest;
    if (good) continue;
    texcoords = {};
    ++flawed;
  }
  for (Vec4& color : scene.colors)
    for (int channel = 0; channel < 4; ++channel) color[channel] = within(color[channel], 0, 1);
  if (flawed == 0) return;
  scene.warnings.push_back(fmt::format("{} not finite or beyond a million became 0",
                                       counted(flawed, "texture coordinate")));
}

}  // namespace

std::array<TextureUse*, 9> usesOf(Material& m) {
  return {&m.base_color_texture,
          &m.metallic_roughness_texture,
          &m.emission_texture,
          &m.normal_texture,
          &m.transmission_texture,
          &m.clearcoat_texture,
          &m.clearcoat_roughness_texture,
          &m.sheen_color_texture,
          &m.sheen_roughness_texture};
}

std::array<const TextureUse*, 9> usesOf(const Material& material) {
  std::array<const TextureUse*, 9> uses{};
  // Only to have the list once: nothing is written.
  const std::array<TextureUse*, 9> all = usesOf(const_cast<Material&>(material));
  std::copy(all.begin(), all.end(), uses.begin());
  return uses;
}

Material shadedAs(const Material& material) {
  if (!material.unlit) return material;
  Material emitter;
  emitter.name = material.name;
  emitter.base_color = Vec3(0);
  emitter.emission = material.base_color;
  emitter.emission_texture = material.base_color_texture;
  emitter.base_color_texture = material.base_color_texture;
  emitter.unlit = true;
  emitter.alpha_mode = material.alpha_mode;
  emitter.alpha = material.alpha;
  emitter.alpha_cutoff = material.alpha_cutoff;
  return emitter;
}

Vec3 meanOfColors(const TextureImage& image) {
  std::array<std::array<std::size_t, 256>, 3> counts{};
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    for (std::size_t channel = 0; channel < 3; ++channel)
      ++counts[channel][image.rgba[i + channel]];
  glm::dvec3 sum(0);
  for (std::size_t value = 0; value < 256; ++value)
    for (std::size_t channel = 0; channel < 3; ++channel)
      sum[static_cast<int>(channel)] += static_cast<double>(counts[channel][value]) *
                                        linearOfSrgb(static_cast<std::uint8_t>(value));
  return Vec3(sum / std::max(1.0, static_cast<double>(image.rgba.size() / 4)));
}

void checkTextures(Scene& scene) {
  checkUses(scene);
  checkIndices(scene);
  checkAttributes(scene);
}

}  // namespace glimt
