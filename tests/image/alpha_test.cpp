// Surfaces that light passes.
#include <catch2/catch.hpp>

#include "tests/image/pictures.h"
#include "tests/image/textured_quad.h"

using namespace glimt;
using namespace glimt::test;

namespace {

Material black(float alpha) {
  Material material = lambert("black", Vec3(0));
  material.alpha_mode = AlphaMode::blend;
  material.alpha = alpha;
  return material;
}

RenderSettings settingsWith(const std::string& traversal, int size, int bounces) {
  RenderSettings settings = settingsFor(size, bounces);
  settings.traversal = traversal;
  return settings;
}

}  // namespace

TEST_CASE("a mask's hole shows what is behind, and the rest is opaque") {
  const std::string traversal = GENERATE("octant", "stack", "linear");
  Scene scene;
  Material material = unlit();
  material.alpha_mode = AlphaMode::mask;
  material.base_color_texture =
      addImage(scene, 2, 1, {255, 255, 255, 120, 255, 255, 255, 130});  // cut at 127.5
  addPicture(scene, material);
  scene.environment.color = Vec3(0.25f);
  const Image image = render(scene, settingsWith(traversal, 8, 0), 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    CHECK(image.pixels[i].g == Approx(i % 8 < 4 ? 0.25 : 1.0));
}

TEST_CASE("the camera sees through surfaces of alpha by the product of what each lets pass") {
  const std::string traversal = GENERATE("octant", "stack", "linear");
  Scene scene;
  scene.environment.color = Vec3(1);
  double passes = 1;
  float z = 0;
  for (const float alpha : {0.5f, 0.25f, 0.5f, 0.1f}) {
    addPictureAt(scene, black(alpha), z);
    z -= 0.5f;
    passes *= 1 - double{alpha};
    const double mean = meanOf(render(scene, settingsWith(traversal, 32, 0), 128)).g;
    INFO("surfaces " << scene.materials.size());
    // 131072 samples, each all or nothing: four standard errors are at most 0.0055.
    CHECK(mean == Approx(passes).margin(0.0055));
  }
}

TEST_CASE("a shadow ray is weakened by exactly what a surface stops") {
  const auto lit = [](float alpha) {
    Scene scene;
    addQuad(scene, Vec3(-1, 0, 1), Vec3(2, 0, 0), Vec3(0, 0, -2),
            add(scene, lambert("floor", Vec3(0.8f))));
    addQuad(scene, Vec3(-0.2f, 3, -0.2f), Vec3(0.4f, 0, 0), Vec3(0, 0, 0.4f),
            add(scene, lambert("light", Vec3(0), Vec3(50))));
    Material shade = black(alpha);
    if (alpha == 0) shade.alpha_mode = AlphaMode::blend;
    addQuad(scene, Vec3(-2, 2, -2), Vec3(4, 0, 0), Vec3(0, 0, 4), add(scene, shade));
    scene.camera.position = Vec3(0, 1, 1.5f);
    scene.camera.target = Vec3(0);
    scene.camera.vertical_fov = 30;
    return render(scene, settingsFor(16, 0), 8);
  };
  const Image without = lit(0);
  const Image half = lit(0.5f);
  CHECK(meanOf(without).g > 0.1);
  for (std::size_t i = 0; i < half.pixels.size(); ++i)
    CHECK(half.pixels[i].g == Approx(0.5 * without.pixels[i].g).epsilon(1e-5));
}

TEST_CASE("light through a shell of alpha reaches a body alike by light samples and by paths") {
  Scene scene;
  addSphere(scene, 1, 3, add(scene, lambert("body", Vec3(0.8f))));
  addCube(scene, 2, add(scene, black(0.5f)));
  scene.environment.color = Vec3(1);
  scene.camera.position = Vec3(0, 0, 3);  // outside the shell
  scene.camera.vertical_fov = 20;         // the body fills the picture
  const double mean = meanOf(render(scene, settingsFor(48, GENERATE(0, 1)), 64)).g;
  // Through the shell to the body, and from there to the camera.
  CHECK(mean == Approx(0.25 * 0.8).epsilon(0.01));
}

TEST_CASE("a shell of alpha shines as much less as it covers") {
  Scene scene;
  addSphere(scene, 1, 3, add(scene, lambert("body", Vec3(0.8f))));
  Material shell = black(0.5f);
  shell.emission = Vec3(1);
  addCube(scene, 10, add(scene, shell));
  scene.camera.position = Vec3(0, 0, 3);
  scene.camera.vertical_fov = 20;
  const double mean = meanOf(render(scene, settingsFor(48, GENERATE(0, 1)), 128)).g;
  CHECK(mean == Approx(0.5 * 0.8).epsilon(0.01));
}
