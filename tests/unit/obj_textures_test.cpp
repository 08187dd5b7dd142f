// Pictures that an MTL names.
#include <catch2/catch.hpp>

#include "renderer/core/image_codecs.h"
#include "renderer/scene/load_scene.h"
#include "renderer/scene/texture_image.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;

namespace {

const std::string kTriangle =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0.25\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3\n";

Scene loadWith(const std::string& mtl, const std::string& obj = kTriangle) {
  const TemporaryFolder folder;
  folder.write("red.png", encodePng({2, 1, {255, 0, 0, 200, 10, 0}}));
  folder.write("grey.png", encodePng({1, 1, {100, 100, 100}}));
  folder.write("blue.png", encodePng({1, 1, {128, 128, 255}}));
  folder.write("model.mtl", "newmtl m\n" + mtl);
  return loadScene(folder.write("model.obj", "mtllib model.mtl\n" + obj));
}

bool warns(const Scene& scene, const std::string& about) {
  for (const std::string& warning : scene.warnings)
    if (warning.find(about) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("a picture of colour is read with its coordinates, v turned, and multiplies Kd") {
  const Scene scene = loadWith("map_Kd red.png\n");
  REQUIRE(scene.images.size() == 1);
  CHECK(scene.images[0].width == 2);
  CHECK(scene.images[0].rgba == std::vector<std::uint8_t>{255, 0, 0, 255, 200, 10, 0, 255});
  const Material& material = scene.materials[0];
  CHECK(material.base_color == Vec3(1));
  CHECK(material.base_color_texture.image == 0);
  REQUIRE(scene.triangles[0].textured());
  CHECK(scene.texcoords[scene.triangles[0].texcoords[1]].sets[0] == Vec2(1, 0.75f));
  CHECK(loadWith("Kd 0.5 0.5 0.5\nmap_Kd red.png\n").materials[0].base_color == Vec3(0.5f));
}

TEST_CASE("the options -s, -o and -clamp move the picture, with v running up") {
  const Scene scene = loadWith("map_Kd -s 2 3 1 -o 0.25 0.5 0 -clamp on red.png\n");
  const TextureUse& use = scene.materials[0].base_color_texture;
  CHECK(use.wrap_u == Wrap::clamp);
  CHECK(use.wrap_v == Wrap::clamp);
  const float up = 0.3f;  // the picture's v is 3 * 0.3 + 0.5, and 1 less that from the top
  CHECK(use.scale.x * 0.1f + use.offset.x == Approx(0.45f));
  CHECK(use.scale.y * (1 - up) + use.offset.y == Approx(1 - (3 * up + 0.5f)));
}

TEST_CASE("a picture that is missing or damaged is a warning, and leaves the factor") {
  const Scene missing = loadWith("Kd 0.1 0.2 0.3\nmap_Kd none.png\n");
  CHECK(warns(missing, "no picture 'none.png'"));
  CHECK(missing.materials[0].base_color == Vec3(0.1f, 0.2f, 0.3f));
  CHECK_FALSE(missing.materials[0].base_color_texture.used());
  CHECK(warns(loadWith("map_Kd model.mtl\n"), "a texture is left out"));
}

TEST_CASE("a picture of alpha becomes the alpha of the picture of colour") {
  const Scene scene = loadWith("map_Kd red.png\nmap_d grey.png\n");
  const Material& material = scene.materials[0];
  CHECK(material.alpha_mode == AlphaMode::blend);
  const TextureImage& image = scene.images[material.base_color_texture.image];
  CHECK(image.rgba == std::vector<std::uint8_t>{255, 0, 0, 100, 200, 10, 0, 100});
  const Scene dissolved = loadWith("d 0.25\n");
  CHECK(dissolved.materials[0].alpha == 0.25f);
  CHECK(dissolved.materials[0].alpha_mode == AlphaMode::blend);
}

TEST_CASE("roughness and metallic share a picture, and each is white where there is none") {
  const Scene scene = loadWith("map_Pr grey.png\n");
  const TextureUse& use = scene.materials[0].metallic_roughness_texture;
  REQUIRE(use.used());
  CHECK(scene.images[use.image].rgba == std::vector<std::uint8_t>{255, 100, 255, 255});
}

TEST_CASE("a bump map is taken where it holds normals, and left out where it holds heights") {
  CHECK(loadWith("norm blue.png\n").materials[0].normal_texture.used());
  CHECK(loadWith("map_Bump blue.png\n").materials[0].normal_texture.used());
  const Scene heights = loadWith("map_Bump grey.png\n");
  CHECK_FALSE(heights.materials[0].normal_texture.used());
  CHECK(warns(heights, "bump maps of heights are left out: 'grey.png'"));
}

TEST_CASE("texture coordinates that the file does not have cost a face its texture alone") {
  const Scene scene = loadWith("map_Kd red.png\n",
                               "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\n"
                               "f 1/1 2/7 3/1\nf 1/-9 2/1 3/1\nf 1/1 2/1 3/1\n");
  REQUIRE(scene.triangles.size() == 3);
  CHECK_FALSE(scene.triangles[0].textured());
  CHECK_FALSE(scene.triangles[1].textured());
  CHECK(scene.triangles[2].textured());
  CHECK(warns(scene, "2 faces without a texture"));
}

TEST_CASE("a picture of odd size is halved to the larger half, and an even one keeps its mean") {
  const TextureImage half = halved({"", 3, 1, std::vector<std::uint8_t>(12, 90)});
  CHECK(half.width == 2);
  CHECK(half.height == 1);
  CHECK(half.rgba == std::vector<std::uint8_t>(8, 90));
}
