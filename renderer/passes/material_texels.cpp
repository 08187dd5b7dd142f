#include "renderer/passes/material_texels.h"

#include <cmath>

#include "renderer/passes/gloss_table.h"
#include "renderer/scene/texture_uses.h"
#include "renderer/scene/transmission.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

// Less than any density that matters, and as a number's sign it still says that both sides emit.
constexpr float kNoDensity = 1e-30f;

float numberOf(Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return 0;
    case Wrap::mirror:
      return 1;
    case Wrap::clamp:
      break;
  }
  return 2;
}

void packSurface(const Material& material, double density, std::vector<Vec4>& texels) {
  const float least = material.unlit ? kNoDensity : static_cast<float>(density);
  texels.emplace_back(material.base_color, material.metallic);
  texels.emplace_back(material.emission, material.double_sided ? -least : least);
  texels.emplace_back(material.roughness, material.specular, material.ior, material.transmission);
}

// Of what is inside, and over the rest.
void packLayers(const Material& material, const std::vector<float>& iors,
                std::vector<Vec4>& texels) {
  texels.emplace_back(absorptionOf(material), material.thin_walled ? 1.0f : 0.0f);
  texels.emplace_back(material.clearcoat, material.clearcoat_roughness, material.sheen_roughness,
                      static_cast<float>(squareOfIor(iors, material.ior)));
  texels.emplace_back(material.sheen_color, material.shadow_catcher ? 1.0f : 0.0f);
}

Vec4 factorsOf(const Material& material) {
  // An opaque surface is one with holes where alpha is below zero.
  const bool passable = material.alpha_mode != AlphaMode::opaque;
  const bool mask = material.alpha_mode == AlphaMode::mask;
  const float cutoff = mask ? material.alpha_cutoff : (passable ? -1.0f : 0.0f);
  return {passable ? material.alpha : 1.0f, cutoff, material.normal_scale,
          material.unlit ? 1.0f : 0.0f};
}

void packUse(const TextureUse& use, const TextureAtlas& atlas, std::vector<Vec4>& texels) {
  if (!use.used()) {
    texels.insert(texels.end(), static_cast<std::size_t>(TEXTURE_USE_TEXELS), Vec4(0));
    return;
  }
  const AtlasRectangle& rectangle = atlas.rectangles()[use.image];
  const float c = std::cos(use.rotation);
  const float s = std::sin(use.rotation);
  texels.emplace_back(rectangle.x, rectangle.y, rectangle.width, rectangle.height);
  // Counter-clockwise as seen on the picture, whose v runs down.
  texels.emplace_back(c * use.scale.x, s * use.scale.y, -s * use.scale.x, c * use.scale.y);
  texels.emplace_back(use.offset,
                      numberOf(use.wrap_u) + 4 * numberOf(use.wrap_v) + (use.nearest ? 16 : 0),
                      use.texcoords);
}

}  // namespace

std::vector<Vec4> packMaterials(const Scene& scene, const LightTable& lights,
                                const TextureAtlas& atlas) {
  const std::vector<float> iors = tabulatedIors(scene);
  std::vector<Vec4> texels;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material material = shadedAs(scene.materials[i]);
    packSurface(material, lights.densities[i], texels);
    packLayers(material, iors, texels);
    texels.push_back(factorsOf(material));
    for (const TextureUse* use : usesOf(material)) packUse(*use, atlas, texels);
  }
  return texels;
}

}  // namespace glimt
