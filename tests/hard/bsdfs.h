// The BSDFs that the hard cases try, one after the other.
#pragma once

#include <array>

#include "tests/image/scenes.h"

namespace glimt::test {

// A surface that reflects the share `albedo` of all light alike, from and to whatever direction.
struct Bsdf {
  const char* name;
  Material (*material)(float albedo, float emission);
};

inline constexpr std::array kBsdfs{
    Bsdf{"Lambert",
         [](float albedo, float emission) {
           return lambert("surface", Vec3(albedo), Vec3(emission));
         }},
};

// A white surface that gives back all light that it gets, from whatever direction; where it goes
// depends on that direction.
struct LosslessBsdf {
  const char* name;
  void (*set)(Material& white);

  Material material(float emission) const {
    Material white = lambert("surface", Vec3(1), Vec3(emission));
    set(white);
    return white;
  }
};

// What they get comes back on the side that it came from. What rough ones reflect several times
// between their facets is made up for from tables.
inline constexpr std::array kReflectors{
    LosslessBsdf{"mirror",
                 [](Material& m) {
                   m.metallic = 1;
                   m.roughness = 0;
                 }},
    LosslessBsdf{"metal, roughness 0.3",
                 [](Material& m) {
                   m.metallic = 1;
                   m.roughness = 0.3f;
                 }},
    LosslessBsdf{"metal, roughness 1", [](Material& m) { m.metallic = 1; }},
    LosslessBsdf{"smooth dielectric over white",
                 [](Material& m) {
                   m.specular = 1;
                   m.roughness = 0;
                 }},
    LosslessBsdf{"dielectric over white, roughness 0.3",
                 [](Material& m) {
                   m.specular = 1;
                   m.roughness = 0.3f;
                 }},
    LosslessBsdf{"sheen over white, roughness 0.3",
                 [](Material& m) {
                   m.sheen_color = Vec3(1);
                   m.sheen_roughness = 0.3f;
                 }},
    LosslessBsdf{"smooth coat over white", [](Material& m) { m.clearcoat = 1; }},
    LosslessBsdf{"coat over metal, both of roughness 0.3",
                 [](Material& m) {
                   m.metallic = 1;
                   m.roughness = 0.3f;
                   m.clearcoat = 1;
                   m.clearcoat_roughness = 0.3f;
                 }},
};

// What they get is reflected or goes through; IOR 1.5.
inline constexpr std::array kGlasses{
    LosslessBsdf{"glass",
                 [](Material& m) {
                   m.specular = m.transmission = 1;
                   m.roughness = 0;
                 }},
    LosslessBsdf{"glass, roughness 0.3",
                 [](Material& m) {
                   m.specular = m.transmission = 1;
                   m.roughness = 0.3f;
                 }},
    LosslessBsdf{"glass, roughness 1", [](Material& m) { m.specular = m.transmission = 1; }},
    LosslessBsdf{"thin wall of glass",
                 [](Material& m) {
                   m.specular = m.transmission = 1;
                   m.roughness = 0;
                   m.thin_walled = true;
                 }},
};

}  // namespace glimt::test
