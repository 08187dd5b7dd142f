#include <cmath>

#include "assets/generate/christmas/parts.h"
#include "assets/generate/pictures/wood.h"

namespace glimt::assets::christmas {
namespace {

Material glass(const dvec3& tint) {
  Material m = plain(tint, 0);
  m.transmission = 1;
  return m;
}

Material wood(double shade) {
  Material m = plain(dvec3(shade), 0.34);
  m.base_color_picture = "wood";
  return m;
}

Material light(const dvec3& radiance) {
  Material m = plain(dvec3(0.02), 1);
  m.emission = radiance;
  return m;
}

}  // namespace

void addFinishes(Model& model) {
  model.pictures.push_back(woodGrain("wood", 512));
  auto& m = model.materials;
  m["needles"] = plain({0.042, 0.125, 0.042}, 0.55);
  m["bark"] = plain({0.10, 0.062, 0.036}, 0.9);
  m["copper"] = metal({0.80, 0.42, 0.26}, 0.24);
  m["red bauble"] = metal({0.70, 0.020, 0.022}, 0.08);
  m["red satin bauble"] = metal({0.55, 0.025, 0.025}, 0.36);
  m["gold bauble"] = metal({0.92, 0.62, 0.24}, 0.10);
  m["silver bauble"] = metal({0.86, 0.86, 0.87}, 0.08);
  m["frosted bauble"] = plain({0.78, 0.76, 0.72}, 0.5);
  m["glass bauble"] = glass({0.97, 0.98, 0.98});
  m["amber glass bauble"] = glass({0.95, 0.62, 0.26});
  m["gold trim"] = metal({0.86, 0.60, 0.28}, 0.28);
  m["star"] = metal({0.95, 0.68, 0.28}, 0.20);
  m["cable"] = plain({0.012, 0.035, 0.014}, 0.5);
  m["bulb"] = light({17, 9.5, 3.4});
  m["flame"] = light({26, 13, 3.6});
  m["wax"] = plain({0.82, 0.75, 0.60}, 0.5);
  m["iron"] = plain(dvec3(0.018), 0.45);
  m["red paper"] = plain({0.40, 0.018, 0.020}, 0.35);
  m["cream paper"] = plain({0.76, 0.68, 0.52}, 0.45);
  m["green paper"] = plain({0.022, 0.115, 0.052}, 0.35);
  m["navy paper"] = plain({0.018, 0.035, 0.105}, 0.32);
  m["kraft paper"] = plain({0.42, 0.28, 0.15}, 0.7);
  m["gold ribbon"] = metal({0.86, 0.60, 0.26}, 0.30);
  m["silver ribbon"] = metal({0.80, 0.80, 0.82}, 0.30);
  m["red ribbon"] = plain({0.48, 0.016, 0.020}, 0.30);
  m["green ribbon"] = plain({0.020, 0.13, 0.05}, 0.30);
  m["light planks"] = wood(0.95);
  m["planks"] = wood(0.78);
  m["dark planks"] = wood(0.62);
  m["rug"] = plain({0.62, 0.56, 0.47}, 1);
  m["rug stripe"] = plain({0.34, 0.03, 0.03}, 1);
  m["wall paint"] = plain({0.30, 0.335, 0.30}, 0.9);
  m["white paint"] = plain({0.70, 0.68, 0.63}, 0.5);
  m["picture"] = plain({0.10, 0.16, 0.20}, 0.6);
  m["curtain"] = plain({0.36, 0.045, 0.04}, 0.9);
  m["brass"] = metal({0.80, 0.60, 0.30}, 0.25);
  m["sky"] = light({0.50, 0.95, 2.2});
  m["evening glow"] = light({2.0, 1.5, 1.6});
  m["snow"] = plain({0.85, 0.87, 0.92}, 0.9);
  m["dark fir"] = plain({0.02, 0.04, 0.035}, 0.9);
}

}  // namespace glimt::assets::christmas
