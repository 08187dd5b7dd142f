#include "renderer/scene/mtl_material.h"

#include <algorithm>
#include <cmath>

namespace glimt {
namespace {

constexpr float kOrdinaryIor = 1.5f;
constexpr float kOrdinaryGloss =
    0.5f;  // the roughness of a surface whose file says only that it shines
// Up to this strength Ks is the gloss of a dielectric: exporters write it for ordinary plastic.
constexpr float kDielectricKs = 0.5f;

Vec3 vectorOf(const tinyobj::real_t (&values)[3]) {
  return {values[0], values[1], values[2]};
}

// Without a Kd: grey, or what the picture says.
Vec3 diffuseOf(const tinyobj::material_t& m) {
  const Vec3 given = vectorOf(m.diffuse);
  if (given != Vec3(-1)) return given;
  return m.diffuse_texname.empty() ? Material().base_color : Vec3(1);
}

float largestOf(const Vec3& v) {
  return std::max(v.x, std::max(v.y, v.z));
}

bool isMirror(int illum) {
  return illum == 3 || illum == 5 || illum == 8;
}

bool isGlass(int illum) {
  return illum == 4 || illum == 6 || illum == 7 || illum == 9;
}

// That of GGX whose highlight is as wide as that of the exponent: Walter et al. 2007, section 5.
float roughnessOf(float exponent) {
  if (!(exponent >= 0)) return kOrdinaryGloss;
  return std::pow(2 / (exponent + 2), 0.25f);
}

bool isGrey(const Vec3& v) {
  return v.x == v.y && v.y == v.z;
}

// A surface that reflects Ks in its highlight, and Kd beside it.
void mixWithMetal(Material& material, const Vec3& diffuse, const Vec3& specular) {
  const Vec3 sum = diffuse + specular;
  material.base_color = sum / std::max(largestOf(sum), 1.0f);
  material.metallic =
      largestOf(specular) / std::max(largestOf(specular) + largestOf(diffuse), 1e-6f);
}

void applyHighlight(Material& material, const tinyobj::material_t& m) {
  const Vec3 specular = vectorOf(m.specular);
  const float strength = largestOf(specular);
  if (m.illum < 2 || !(strength > 0)) return;
  material.roughness = isMirror(m.illum) ? 0 : roughnessOf(m.shininess);
  if (!isMirror(m.illum) && strength <= kDielectricKs && isGrey(specular)) {
    material.specular = strength / kDielectricKs;
    return;
  }
  mixWithMetal(material, diffuseOf(m), specular);
}

// Light is tinted where it enters and where it leaves. Only the hue of Tf counts: of its strength
// some exporters write what passes, others what does not.
void applyGlass(Material& material, const tinyobj::material_t& m) {
  material.transmission = m.dissolve < 1 ? 1 - m.dissolve : 1;
  material.specular = 1;
  material.roughness = 0;
  const Vec3 filter = vectorOf(m.transmittance);
  const float most = largestOf(filter);
  material.base_color = Vec3(1);
  if (!(most > 0)) return;
  for (int c = 0; c < 3; ++c)
    material.base_color[c] = std::sqrt(std::clamp(filter[c] / most, 0.0f, 1.0f));
}

// The extension for physically based rendering wins over Ks and Ns.
void applyPhysical(Material& material, const tinyobj::material_t& m) {
  const bool roughness_given = m.roughness >= 0;
  const bool metallic_given = m.metallic >= 0;
  if (metallic_given || (roughness_given && !isGlass(m.illum))) {
    material.base_color = isGlass(m.illum) ? material.base_color : diffuseOf(m);
    material.metallic = metallic_given ? m.metallic : 0;
    material.specular = 1;
    material.roughness = roughnessOf(m.shininess);
  }
  if (roughness_given) material.roughness = m.roughness;
  material.clearcoat = m.clearcoat_thickness;
  material.clearcoat_roughness = m.clearcoat_roughness;
  material.sheen_color = Vec3(m.sheen);
  material.sheen_roughness = kOrdinaryGloss;
}

}  // namespace

Material materialOfMtl(const tinyobj::material_t& m) {
  Material material;
  material.base_color = diffuseOf(m);
  material.emission = vectorOf(m.emission);
  if (!m.emissive_texname.empty() && material.emission == Vec3(0)) material.emission = Vec3(1);
  if (isGlass(m.illum)) {
    material.ior = m.ior >= 1 ? m.ior : kOrdinaryIor;
    applyGlass(material, m);
  } else {
    // Many files say 1 of surfaces that they mean to shine.
    material.ior = m.ior > 1 ? m.ior : kOrdinaryIor;
    applyHighlight(material, m);
    // Nothing is left at 0, which many files say where they mean 1.
    if (m.dissolve > 0 && m.dissolve < 1) {
      material.alpha_mode = AlphaMode::blend;
      material.alpha = m.dissolve;
    }
  }
  applyPhysical(material, m);
  return material;
}

}  // namespace glimt
