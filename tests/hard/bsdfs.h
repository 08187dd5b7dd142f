// The BSDFs that the hard cases try, one after the other.
#pragma once

#include <array>

#include "tests/image/scenes.h"

namespace glimt::test {

// A surface that reflects the share `albedo` of all light, whatever its direction. A BSDF that has
// no such surface is none of these.
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

}  // namespace glimt::test
