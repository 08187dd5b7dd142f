// White furnaces: no surface gives back more light than it gets, and those that should give back
// all of it do.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/shader/bsdfs.h"
#include "tests/shader/report.h"

using namespace glimt;
using namespace glimt::test;

namespace {

const std::vector<double> kRoughnesses{0, 0.1, 0.2, 0.4, 0.7, 1};
const std::vector<double> kIors{1, 1.1, 1.5, 2.5};
const std::vector<double> kCosines{0.01, 0.1, 0.3, 0.6, 1};

struct Albedos {
  double least = 1e30;
  double most = 0;
  std::string least_at;
  std::string most_at;

  void add(double albedo, const Surface& s, double cosine) {
    const std::string at =
        fmt::format("roughness {}, IOR {}, cosine {}", s.roughness, s.ior, cosine);
    if (albedo < least) least_at = at;
    if (albedo > most) most_at = at;
    least = std::min(least, albedo);
    most = std::max(most, albedo);
  }
};

bool reflectsOnly(const Surface& s) {
  return s.transmission == 0 && s.specular == 0;
}

// Over all roughnesses, of the layers above too, indices of refraction and angles.
Albedos albedosOf(Surface s) {
  Albedos albedos;
  for (const double roughness : kRoughnesses)
    for (const double ior : kIors) {
      if (ior != 1.5 && reflectsOnly(s)) continue;
      // Such a boundary has no facets to be seen by; see scene_check.cpp.
      if (ior == 1 && s.transmission > 0 && roughness > 0 && !s.thin) continue;
      s.roughness = s.sheen_roughness = roughness;
      s.ior = ior;
      if (s.clearcoat_roughness > 0) s.clearcoat_roughness = std::max(roughness, 0.02);
      // Fibres reflect into a narrow band along the surface, and are sampled evenly.
      const int side = s.sheen > 0 ? 64 : 32;
      for (const double cosine : kCosines) albedos.add(albedoOf(s, cosine, side), s, cosine);
    }
  return albedos;
}

// Whether all of the light is to come out.
bool givesAllBack(const Surface& s) {
  return s.base_color.x == 1 && (s.metallic == 0 || s.metallic == 1);
}

}  // namespace

TEST_CASE("no surface gives back more light than it gets, and white ones all of it") {
  for (const Surface& s : kindsOfSurface()) {
    const Albedos albedos = albedosOf(s);
    report("{}: gives back {:.5f} ({}) to {:.5f} ({})", s.name, albedos.least, albedos.least_at,
           albedos.most, albedos.most_at);
    INFO(s.name);
    CHECK(albedos.most <= 1.002);
    if (givesAllBack(s)) CHECK(albedos.least >= 0.99);
  }
}
