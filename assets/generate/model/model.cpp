#include "assets/generate/model/model.h"

namespace glimt::assets {

Material plain(const dvec3& color, double roughness) {
  Material m;
  m.base_color = color;
  m.roughness = roughness;
  return m;
}

Material metal(const dvec3& color, double roughness) {
  Material m = plain(color, roughness);
  m.metallic = 1;
  return m;
}

}  // namespace glimt::assets
