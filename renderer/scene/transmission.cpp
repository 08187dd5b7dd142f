#include "renderer/scene/transmission.h"

#include <algorithm>
#include <cmath>

namespace glimt {

bool transmits(const Material& material) {
  const bool metal = material.metallic == 1 && !material.metallic_roughness_texture.used();
  return !material.unlit && !metal && material.transmission > 0;
}

Vec3 absorptionOf(const Material& material) {
  constexpr float kNothingLeft = 80;  // as an exponent; of black, which has no logarithm
  constexpr float kMost = 1e30f;      // its product with a distance is finite
  const bool absorbs =
      transmits(material) && !material.thin_walled && material.attenuation_distance > 0;
  Vec3 absorption(0);
  if (!absorbs) return absorption;
  for (int c = 0; c < 3; ++c) {
    const float left = material.attenuation_color[c];
    const float exponent =
        left > 0 ? std::clamp(-std::log(left), 0.0f, kNothingLeft) : kNothingLeft;
    absorption[c] = std::min(exponent / material.attenuation_distance, kMost);
  }
  return absorption;
}

}  // namespace glimt
