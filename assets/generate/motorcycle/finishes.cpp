#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

// Colour with flakes below a clear coat.
Material lacquer(const dvec3& color, double flakes) {
  Material m = plain(color, 0.45);
  m.metallic = flakes;
  m.clearcoat = 1;
  m.clearcoat_roughness = 0.02;
  return m;
}

Material leather(const dvec3& color) {
  Material m = plain(color, 0.48);
  m.sheen_color = 0.12 * color + 0.01;
  m.sheen_roughness = 0.5;
  return m;
}

Material lens(const dvec3& color) {
  Material m = plain(color, 0.08);
  m.clearcoat = 1;
  return m;
}

Material clearGlass() {
  Material m = plain(dvec3(1), 0);
  m.transmission = 1;
  return m;
}

const dvec3 kGold{0.82, 0.56, 0.22}, kSilver{0.80, 0.80, 0.79}, kCream{0.78, 0.70, 0.53};

void addBase(Model& model) {
  auto& m = model.materials;
  m["chrome"] = metal({0.78, 0.79, 0.80}, 0.06);
  m["mirror"] = metal({0.90, 0.90, 0.90}, 0.03);
  m["polished alloy"] = metal({0.80, 0.80, 0.79}, 0.20);
  m["cast alloy"] = metal({0.58, 0.58, 0.57}, 0.42);
  m["steel"] = metal({0.62, 0.61, 0.60}, 0.25);
  m["disc steel"] = metal({0.50, 0.50, 0.50}, 0.30);
  m["brass"] = metal({0.75, 0.58, 0.30}, 0.28);
  m["gauze"] = metal({0.45, 0.44, 0.42}, 0.45);
  m["black metal"] = plain(dvec3(0.022), 0.35);
  m["soot"] = plain(dvec3(0.012), 0.9);
  m["rubber"] = plain(dvec3(0.020), 0.62);
  m["black rubber"] = plain(dvec3(0.018), 0.50);
  m["ceramic"] = plain(dvec3(0.8), 0.2);
  m["white"] = plain(dvec3(0.8), 0.4);
  m["dial"] = plain(dvec3(0.012), 0.4);
  m["needle"] = plain({0.75, 0.06, 0.02}, 0.35);
  m["amber"] = lens({0.85, 0.26, 0.01});
  m["red lens"] = lens({0.55, 0.006, 0.006});
  m["clear glass"] = clearGlass();
}

}  // namespace

void addFinishes(Model& model) {
  addBase(model);
  const Material black_gloss = lacquer(dvec3(0.010), 0);
  const Material bright_engine = metal({0.62, 0.62, 0.61}, 0.38);
  const std::map<std::string, Material> green = {{"paint", lacquer({0.010, 0.085, 0.035}, 0.35)},
                                                 {"accent", lacquer({0.006, 0.038, 0.018}, 0.2)},
                                                 {"line", metal(kGold, 0.22)},
                                                 {"leather", leather({0.19, 0.075, 0.028})},
                                                 {"piping", leather({0.11, 0.042, 0.016})},
                                                 {"rim", metal(kSilver, 0.16)},
                                                 {"engine", bright_engine},
                                                 {"exhaust", metal({0.78, 0.79, 0.80}, 0.07)},
                                                 {"frame", black_gloss},
                                                 {"spring", metal({0.78, 0.79, 0.80}, 0.08)},
                                                 {"mudguard", metal({0.78, 0.79, 0.80}, 0.07)},
                                                 {"headlamp", black_gloss}};
  auto red = green;
  red["paint"] = lacquer({0.42, 0.010, 0.008}, 0.25);
  red["accent"] = lacquer(kCream, 0);
  red["line"] = metal(kGold, 0.22);
  red["leather"] = leather(dvec3(0.018));
  red["piping"] = leather({0.40, 0.34, 0.26});
  red["mudguard"] = red["paint"];
  red["headlamp"] = red["paint"];

  auto blue = green;
  blue["paint"] = lacquer({0.010, 0.030, 0.150}, 0.5);
  blue["accent"] = lacquer({0.55, 0.57, 0.58}, 0.7);
  blue["line"] = lacquer({0.60, 0.05, 0.02}, 0);
  blue["leather"] = leather({0.055, 0.035, 0.026});
  blue["piping"] = leather({0.20, 0.13, 0.08});
  blue["rim"] = metal(kGold, 0.20);
  blue["mudguard"] = metal({0.72, 0.72, 0.72}, 0.28);
  blue["headlamp"] = blue["paint"];

  auto stealth = green;
  stealth["paint"] = plain(dvec3(0.016), 0.42);
  stealth["accent"] = black_gloss;
  stealth["line"] = metal({0.72, 0.30, 0.10}, 0.25);
  stealth["leather"] = leather(dvec3(0.015));
  stealth["piping"] = leather({0.45, 0.14, 0.03});
  stealth["rim"] = metal(dvec3(0.045), 0.35);
  stealth["engine"] = metal(dvec3(0.06), 0.48);
  stealth["exhaust"] = metal(dvec3(0.075), 0.38);
  stealth["spring"] = lacquer({0.60, 0.16, 0.02}, 0);
  stealth["mudguard"] = plain(dvec3(0.016), 0.42);

  auto orange = green;
  orange["paint"] = lacquer(kCream, 0);
  orange["accent"] = lacquer({0.72, 0.145, 0.010}, 0.1);
  orange["line"] = lacquer(dvec3(0.015), 0);
  orange["leather"] = leather({0.28, 0.12, 0.045});
  orange["piping"] = leather({0.14, 0.06, 0.02});
  orange["frame"] = lacquer({0.055, 0.055, 0.058}, 0.6);
  orange["mudguard"] = orange["paint"];

  for (const auto& [name, material] : green) model.materials[name] = material;
  model.variants = {{"racing green", green},
                    {"signal red", red},
                    {"midnight blue", blue},
                    {"matt black", stealth},
                    {"cream and orange", orange}};
}

}  // namespace glimt::assets::motorcycle
