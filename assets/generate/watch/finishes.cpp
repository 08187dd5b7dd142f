#include "assets/generate/pictures/relief.h"
#include "assets/generate/watch/parts.h"

namespace glimt::assets::watch {
namespace {

// Lacquer over metal, brushed so that it shines out of its depth.
Material dialColor(const dvec3& color, double metallic) {
  Material m = plain(color, 0.38);
  m.metallic = metallic;
  m.clearcoat = 1;
  m.clearcoat_roughness = 0.04;
  return m;
}

Material canvas(const dvec3& color) {
  Material m = plain(color, 0.9);
  m.normal_picture = "canvas";
  m.sheen_color = 0.35 * color + 0.02;
  m.sheen_roughness = 0.6;
  return m;
}

Material leather(const dvec3& color) {
  Material m = plain(color, 0.42);
  m.normal_picture = "leather";
  return m;
}

// Metal of the case in three finishes, and of the trim.
void addMetal(std::map<std::string, Material>& m, const dvec3& color, double roughness) {
  m["metal"] = metal(color, roughness);
  m["brushed metal"] = metal(color, roughness + 0.18);
}

std::map<std::string, Material> steelAndBlue() {
  std::map<std::string, Material> m;
  addMetal(m, {0.70, 0.70, 0.70}, 0.10);
  m["trim"] = metal({0.85, 0.85, 0.85}, 0.12);
  m["hands"] = metal({0.85, 0.85, 0.85}, 0.15);
  m["dial"] = dialColor({0.012, 0.050, 0.19}, 0.6);
  m["dial slope"] = dialColor({0.008, 0.030, 0.11}, 0.4);
  m["small dial"] = metal({0.62, 0.63, 0.65}, 0.28);
  m["bezel"] = dialColor({0.008, 0.028, 0.11}, 0.2);
  m["bezel print"] = metal({0.85, 0.85, 0.85}, 0.25);
  m["print"] = plain({0.75, 0.75, 0.75}, 0.5);
  m["second hand"] = plain({0.70, 0.035, 0.015}, 0.35);
  m["strap"] = canvas({0.018, 0.032, 0.075});
  m["stitches"] = plain({0.70, 0.68, 0.62}, 0.8);
  return m;
}

std::map<std::string, Material> goldAndCream() {
  auto m = steelAndBlue();
  addMetal(m, {0.90, 0.62, 0.30}, 0.10);
  m["trim"] = metal({0.92, 0.64, 0.32}, 0.12);
  m["hands"] = metal({0.92, 0.64, 0.32}, 0.15);
  m["dial"] = dialColor({0.80, 0.74, 0.60}, 0);
  m["dial slope"] = dialColor({0.74, 0.67, 0.52}, 0);
  m["small dial"] = metal({0.85, 0.60, 0.30}, 0.30);
  m["bezel"] = dialColor({0.085, 0.034, 0.014}, 0.2);
  m["bezel print"] = metal({0.92, 0.68, 0.36}, 0.25);
  m["print"] = plain({0.06, 0.04, 0.025}, 0.5);
  m["second hand"] = plain({0.10, 0.045, 0.02}, 0.35);
  m["strap"] = leather({0.17, 0.062, 0.022});
  m["stitches"] = plain({0.62, 0.50, 0.34}, 0.8);
  return m;
}

std::map<std::string, Material> blackAndOrange() {
  auto m = steelAndBlue();
  addMetal(m, dvec3(0.05), 0.22);
  m["trim"] = metal({0.30, 0.30, 0.31}, 0.2);
  m["hands"] = metal({0.55, 0.55, 0.55}, 0.2);
  m["dial"] = dialColor(dvec3(0.010), 0);
  m["dial slope"] = dialColor(dvec3(0.012), 0);
  m["small dial"] = metal(dvec3(0.10), 0.30);
  m["bezel"] = dialColor(dvec3(0.010), 0);
  m["bezel print"] = plain({0.85, 0.26, 0.02}, 0.4);
  m["second hand"] = plain({0.90, 0.24, 0.01}, 0.35);
  m["strap"] = leather(dvec3(0.016));
  m["stitches"] = plain({0.85, 0.25, 0.02}, 0.8);
  return m;
}

std::map<std::string, Material> bronzeAndOlive() {
  auto m = steelAndBlue();
  addMetal(m, {0.62, 0.37, 0.18}, 0.16);
  m["trim"] = metal({0.78, 0.52, 0.28}, 0.14);
  m["hands"] = metal({0.78, 0.52, 0.28}, 0.16);
  m["dial"] = dialColor({0.016, 0.070, 0.034}, 0.5);
  m["dial slope"] = dialColor({0.010, 0.042, 0.020}, 0.3);
  m["small dial"] = metal({0.66, 0.44, 0.24}, 0.30);
  m["bezel"] = dialColor({0.010, 0.040, 0.020}, 0.2);
  m["bezel print"] = metal({0.85, 0.60, 0.34}, 0.25);
  m["second hand"] = metal({0.85, 0.58, 0.30}, 0.2);
  m["strap"] = canvas({0.075, 0.078, 0.036});
  m["stitches"] = plain({0.40, 0.34, 0.20}, 0.8);
  return m;
}

}  // namespace

void addFinishes(Model& model) {
  model.pictures.push_back(
      normalMap("canvas", 256, [](double u, double v) { return wovenHeight(u, v, 16); }));
  model.pictures.push_back(
      normalMap("leather", 256, [](double u, double v) { return grainHeight(u, v, 14); }));
  const auto steel = steelAndBlue();
  model.materials.insert(steel.begin(), steel.end());
  model.materials["luminous"] = plain({0.78, 0.80, 0.70}, 0.6);
  // What a coated crystal still reflects; the rest of the light passes.
  model.materials["crystal"] = metal(dvec3(1), 0);
  model.materials["crystal"].alpha = 0.03;
  Material suede = plain({0.055, 0.052, 0.050}, 0.95);
  suede.sheen_color = {0.07, 0.067, 0.063};
  suede.sheen_roughness = 0.5;
  model.materials["cushion"] = suede;
  model.variants = {{"steel and navy canvas", steel},
                    {"gold and brown leather", goldAndCream()},
                    {"black and orange", blackAndOrange()},
                    {"bronze and olive canvas", bronzeAndOlive()}};
}

}  // namespace glimt::assets::watch
