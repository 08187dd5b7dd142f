// What an MTL's materials stand for: docs/materials.md.
#include <catch2/catch.hpp>

#include "renderer/scene/mtl_file.h"
#include "renderer/scene/transmission.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;

namespace {

Material materialOf(const std::string& lines) {
  const TemporaryFolder folder;
  return readMtlFile(folder.write("m.mtl", "newmtl m\n" + lines)).at(0).material;
}

bool isLambert(const Material& m) {
  return m.metallic == 0 && m.specular == 0 && m.transmission == 0 && m.clearcoat == 0 &&
         m.sheen_color == Vec3(0);
}

}  // namespace

TEST_CASE("an MTL's Kd alone, and Ks that no illumination model uses, is a Lambert surface") {
  CHECK(isLambert(materialOf("Kd 1 0 0\n")));
  CHECK(isLambert(materialOf("Kd 1 0 0\nKs 0 0 0\nNs 10\nNi 1.5\nd 1\nillum 2\n")));
  CHECK(isLambert(materialOf("Kd 1 0 0\nKs 0.5 0.5 0.5\nillum 1\n")));
}

TEST_CASE("weak grey Ks is the gloss of a dielectric, as rough as Ns says") {
  const Material m = materialOf("Kd 1 0 0\nKs 0.25 0.25 0.25\nNs 30\nNi 1.3\nillum 2\n");
  CHECK(m.base_color == Vec3(1, 0, 0));
  CHECK(m.metallic == 0);
  CHECK(m.specular == 0.5f);
  CHECK(m.roughness == Approx(0.5f));  // (2 / 32)^(1/4)
  CHECK(m.ior == 1.3f);
  CHECK(materialOf("Ks 0.5 0.5 0.5\nNi 1\n").ior == 1.5f);
}

TEST_CASE("strong or coloured Ks is a share of metal") {
  const Material m = materialOf("Kd 0.25 0.25 0.25\nKs 0.75 0.75 0.75\nNs 0\nillum 2\n");
  CHECK(m.base_color == Vec3(1));
  CHECK(m.metallic == 0.75f);
  CHECK(m.roughness == 1);
  CHECK(materialOf("Kd 0 0 0\nKs 0.4 0.3 0.1\n").metallic == 1);
  // What reflects more than all is scaled down, and keeps its colour.
  CHECK(materialOf("Kd 1 0.5 0.5\nKs 1 0.5 0.5\n").base_color == Vec3(1, 0.5f, 0.5f));
}

TEST_CASE("illumination models of mirrors give mirrors") {
  const std::string illum = GENERATE("3", "5", "8");
  const Material m = materialOf("Kd 0 0 0\nKs 0.9 0.9 0.9\nNs 100\nillum " + illum + "\n");
  CHECK(m.metallic == 1);
  CHECK(m.roughness == 0);
  CHECK(m.base_color == Vec3(0.9f));
}

TEST_CASE("illumination models of glass give glass, tinted by the hue of Tf") {
  const std::string illum = GENERATE("4", "6", "7", "9");
  const Material m =
      materialOf("Kd 0 0 0\nKs 1 1 1\nTf 0.25 0.0625 0.25\nNi 1.4\nillum " + illum + "\n");
  CHECK(m.transmission == 1);
  CHECK(m.roughness == 0);
  CHECK(m.ior == 1.4f);
  CHECK(m.base_color == Vec3(1, 0.5f, 1));
  CHECK(materialOf("illum 7\nd 0.25\n").transmission == 0.75f);
  CHECK(materialOf("illum 7\n").base_color == Vec3(1));
  CHECK(materialOf("illum 7\nTf 0 0 0\n").base_color == Vec3(1));
  CHECK(materialOf("illum 7\nTf 0.1 0.1 0.1\n").base_color == Vec3(1));
  CHECK(materialOf("illum 7\nPr 0.3\n").roughness == 0.3f);
}

TEST_CASE("d and Tr make a surface see-through, not glass") {
  const std::string line = GENERATE("d 0.25", "Tr 0.75");
  const Material m = materialOf(line + "\nillum 2\n");
  CHECK(m.alpha_mode == AlphaMode::blend);
  CHECK(m.alpha == 0.25f);
  CHECK(m.transmission == 0);
}

TEST_CASE("Pr, Pm, Pc, Pcr and Ps are glTF's terms, and win over Ks and Ns") {
  const Material m =
      materialOf("Kd 1 0 0\nKs 0.9 0.9 0.9\nNs 30\nPr 0.125\nPm 0.5\nPc 1\nPcr 0.25\nPs 0.75\n");
  CHECK(m.base_color == Vec3(1, 0, 0));
  CHECK(m.roughness == 0.125f);
  CHECK(m.metallic == 0.5f);
  CHECK(m.specular == 1);
  CHECK(m.clearcoat == 1);
  CHECK(m.clearcoat_roughness == 0.25f);
  CHECK(m.sheen_color == Vec3(0.75f));
  CHECK(materialOf("Pr 0\n").roughness == 0);
}

TEST_CASE("absorption leaves the colour after the distance, and only inside") {
  Material m;
  m.transmission = 1;
  m.attenuation_color = Vec3(0.5f, 1, 0);
  m.attenuation_distance = 2;
  const Vec3 absorption = absorptionOf(m);
  CHECK(std::exp(-2 * absorption.x) == Approx(0.5f));
  CHECK(absorption.y == 0);
  CHECK(std::exp(-2 * absorption.z) < 1e-30f);
  m.attenuation_distance = 1e-38f;
  CHECK(std::isfinite(absorptionOf(m).z));
  m.attenuation_distance = 0;
  CHECK(absorptionOf(m) == Vec3(0));
  m.attenuation_distance = 2;
  m.thin_walled = true;
  CHECK(absorptionOf(m) == Vec3(0));
  m.thin_walled = false;
  m.transmission = 0;
  CHECK(absorptionOf(m) == Vec3(0));
}
