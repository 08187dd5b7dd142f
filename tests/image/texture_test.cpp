// What pictures do to surfaces.
#include <catch2/catch.hpp>

#include <cmath>

#include "tests/image/pictures.h"
#include "tests/image/textured_quad.h"

using namespace glimt;
using namespace glimt::test;

namespace {

// 4 x 4 texels that differ in every channel.
std::vector<std::uint8_t> sixteenColors() {
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < 16; ++i)
    for (const int value : {i * 17, 255 - i * 15, (i * 71) % 256, 255})
      rgba.push_back(static_cast<std::uint8_t>(value));
  return rgba;
}

// Whether each pixel of a picture of a whole number of pixels a texel is the texel that
// `texel(x, y)` gives, x and y counted in texels from the upper left corner of the picture.
template <class TexelAt>
void checkTexels(const Image& image, int texels, const std::vector<std::uint8_t>& rgba,
                 TexelAt texelAt) {
  const int pixels = image.width / texels;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      INFO("pixel " << x << ", " << y);
      const std::size_t texel = 4 * static_cast<std::size_t>(texelAt(x / pixels, y / pixels));
      const Vec3 pixel =
          image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(x)];
      for (int channel = 0; channel < 3; ++channel)
        REQUIRE(pixel[channel] == Approx(linearOf(rgba[texel + static_cast<std::size_t>(channel)]))
                                      .epsilon(1e-4)
                                      .margin(1e-6));
    }
}

}  // namespace

TEST_CASE("a textured square shows the texels of its picture, lit evenly or unlit") {
  const bool is_unlit = GENERATE(true, false);
  Scene scene;
  Material material = is_unlit ? unlit() : lambert("lit", Vec3(1));
  material.base_color_texture = addImage(scene, 4, 4, sixteenColors());
  addImage(scene, 3, 5, std::vector<std::uint8_t>(60, 77));  // unused, and in nobody's way
  addPicture(scene, material);
  if (!is_unlit) scene.environment.color = Vec3(1);
  checkTexels(render(scene, settingsFor(16, 0), 2), 4, sixteenColors(),
              [](int x, int y) { return 4 * y + x; });
}

TEST_CASE("pictures repeat, are mirrored or end at their edges as each use says") {
  const Wrap wrap = GENERATE(Wrap::repeat, Wrap::mirror, Wrap::clamp);
  Scene scene;
  Material material = unlit();
  material.base_color_texture = addImage(scene, 4, 4, sixteenColors());
  material.base_color_texture.wrap_u = wrap;
  material.base_color_texture.wrap_v = wrap;
  material.base_color_texture.scale = Vec2(3);
  material.base_color_texture.offset = Vec2(-1);
  addPicture(scene, material);
  const auto wrapped = [wrap](int i) {
    if (wrap == Wrap::clamp) return std::min(std::max(i, 0), 3);
    const int k = (i + 8) % 8;
    return wrap == Wrap::repeat ? k % 4 : (k < 4 ? k : 7 - k);
  };
  checkTexels(render(scene, settingsFor(24, 0), 1), 12, sixteenColors(),
              [&](int x, int y) { return 4 * wrapped(y - 4) + wrapped(x - 4); });
}

TEST_CASE("a quarter turn of the coordinates is counter-clockwise, and of the picture clockwise") {
  Scene scene;
  Material material = unlit();
  material.base_color_texture = addImage(scene, 4, 4, sixteenColors());
  material.base_color_texture.rotation = std::acos(-1.0f) / 2;
  addPicture(scene, material);
  // (u, v) looks up (v, -u), which repeats.
  checkTexels(render(scene, settingsFor(16, 0), 1), 4, sixteenColors(),
              [](int x, int y) { return 4 * (3 - x) + y; });
}

TEST_CASE("colours are mixed when they are linear: between black and white is half the light") {
  Scene scene;
  Material material = unlit();
  material.base_color_texture = addImage(scene, 1, 2, {0, 0, 0, 255, 255, 255, 255, 255});
  material.base_color_texture.nearest = false;
  material.base_color_texture.wrap_v = Wrap::clamp;
  addPicture(scene, material);
  const Image image = render(scene, settingsFor(32, 0), 32);
  for (int y = 0; y < 32; ++y) {
    const double expected = std::clamp(((y + 0.5) / 32 - 0.25) / 0.5, 0.0, 1.0);
    INFO("row " << y);
    // A pixel's samples are spread over a sixteenth of the ramp; at its ends that bends it.
    CHECK(image.pixels[static_cast<std::size_t>(y) * 32 + 7].g == Approx(expected).margin(0.01));
  }
}

TEST_CASE("vertex colours are linear and multiply the base colour") {
  const bool is_unlit = GENERATE(true, false);
  Scene scene;
  Material material = is_unlit ? unlit() : lambert("lit", Vec3(1));
  material.base_color = Vec3(0.5f, 1, 1);
  addPicture(scene, material);
  scene.colors.assign(1, Vec4(0.5f, 0.25f, 0, 1));
  for (Triangle& triangle : scene.triangles) triangle.colors = {0, 0, 0};
  if (!is_unlit) scene.environment.color = Vec3(1);
  const glm::dvec3 mean = meanOf(render(scene, settingsFor(8, 0), 2));
  CHECK(mean.r == Approx(0.25).epsilon(1e-4));
  CHECK(mean.g == Approx(0.25).epsilon(1e-4));
  CHECK(mean.b == 0);
}

namespace {

// The light of a small far light in that direction on the square, whose normals the picture of one
// texel turns; none for no texel.
double litFrom(const Vec3& direction, const std::vector<std::uint8_t>& normal) {
  Scene scene;
  Material material = lambert("bumpy", Vec3(1));
  if (!normal.empty()) material.normal_texture = addImage(scene, 1, 1, normal);
  addPicture(scene, material);
  const Vec3 center = 100.0f * glm::normalize(direction);
  const Vec3 side = glm::normalize(glm::cross(direction, Vec3(0.3f, 0.5f, 0.1f)));
  const Vec3 up = glm::normalize(glm::cross(direction, side));
  addQuad(scene, center - side - up, 2.0f * side, 2.0f * up,
          add(scene, lambert("light", Vec3(0), Vec3(1000))));
  return meanOf(render(scene, settingsFor(8, 0), 16)).g;
}

}  // namespace

TEST_CASE("a flat map of normals changes nothing") {
  // 128 is 0.4 percent of a unit to the side: the nearest to zero that eight bits have.
  const double plain = litFrom(Vec3(1, 1, 2), {});
  CHECK(litFrom(Vec3(1, 1, 2), {128, 128, 255, 255}) == Approx(plain).epsilon(0.01));
}

TEST_CASE("a map of normals leans the surface: red to the picture's right, green to its top") {
  const std::vector<std::uint8_t> right{191, 128, 238, 255};  // 30 degrees to +x
  const std::vector<std::uint8_t> top{128, 191, 238, 255};    // and to +y
  const auto ratio = [](const Vec3& light, const std::vector<std::uint8_t>& normal) {
    return litFrom(light, normal) / litFrom(light, {});
  };
  const double degree = std::acos(-1.0) / 180;
  const double towards = std::cos(15 * degree) / std::cos(45 * degree);
  const double away = std::cos(75 * degree) / std::cos(45 * degree);
  CHECK(ratio(Vec3(1, 0, 1), right) == Approx(towards).epsilon(0.02));
  CHECK(ratio(Vec3(-1, 0, 1), right) == Approx(away).epsilon(0.02));
  CHECK(ratio(Vec3(0, 1, 1), top) == Approx(towards).epsilon(0.02));
  CHECK(ratio(Vec3(0, -1, 1), top) == Approx(away).epsilon(0.02));
}

TEST_CASE("a light of which half is black is a light of half the size") {
  const int bounces = GENERATE(0, 3);
  const auto litBy = [bounces](bool textured) {
    Scene scene;
    Material light = lambert("light", Vec3(0), Vec3(5));
    if (textured)
      light.emission_texture = addImage(scene, 2, 1, {255, 255, 255, 255, 0, 0, 0, 255});
    const std::uint32_t index = addPicture(scene, light);
    if (!textured) {
      scene.triangles.clear();
      addQuad(scene, Vec3(-1, -1, 0), Vec3(1, 0, 0), Vec3(0, 2, 0), index);
    }
    addQuad(scene, Vec3(-2, -1, 2), Vec3(4, 0, 0), Vec3(0, 0, -4),
            add(scene, lambert("floor", Vec3(0.7f))));
    scene.camera.position = Vec3(0, 2, 1.5f);
    scene.camera.target = Vec3(0, -1, 1);  // the black half hides none of the floor there
    scene.camera.vertical_fov = 20;
    return meanOf(render(scene, settingsFor(32, bounces), 128)).g;
  };
  CHECK(litBy(true) == Approx(litBy(false)).epsilon(0.01));
}

TEST_CASE("white pictures of every kind, white colours and alpha 1 change nothing") {
  const bool metal = GENERATE(false, true);
  const std::string traversal = GENERATE("octant", "linear");
  const auto picture = [&](bool varied) {
    Scene scene;
    Material material = lambert("body", Vec3(0.8f, 0.5f, 0.3f), Vec3(0.25f));
    material.metallic = metal ? 0.5f : 0;
    material.roughness = metal ? 0.4f : 1;
    material.specular = metal ? 1 : 0;
    if (varied) {
      const TextureUse white = addImage(scene, 2, 1, std::vector<std::uint8_t>(8, 255));
      material.base_color_texture = material.metallic_roughness_texture = white;
      material.emission_texture = material.transmission_texture = white;
      material.normal_texture = addImage(scene, 1, 1, {128, 128, 255, 255});
      material.normal_texture.nearest = false;
      material.alpha_mode = AlphaMode::blend;
      scene.colors.assign(1, Vec4(1));
    }
    addPicture(scene, material);
    addSphere(scene, 0.5f, 2, 0);
    if (varied)
      for (Triangle& triangle : scene.triangles) triangle.colors = {0, 0, 0};
    if (varied) {
      Material shown = unlit();  // behind the camera: its shader, not its light
      addQuad(scene, Vec3(50, 50, 900), Vec3(0.01f, 0, 0), Vec3(0, 0.01f, 0), add(scene, shown));
    }
    scene.environment.color = Vec3(1);
    RenderSettings settings = settingsFor(24, 2);
    settings.traversal = traversal;
    return meanOf(render(scene, settings, 64));
  };
  const glm::dvec3 plain = picture(false);
  const glm::dvec3 varied = picture(true);
  // Eight bits lean a flat normal by a quarter of a degree, and the noise is not the same.
  for (int channel = 0; channel < 3; ++channel)
    CHECK(varied[channel] == Approx(plain[channel]).epsilon(0.01));
}
