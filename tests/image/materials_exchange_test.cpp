// Other materials for a renderer's triangles.
#include <catch2/catch.hpp>

#include "tests/image/pictures.h"
#include "tests/image/scenes.h"
#include "tests/unit/expect_error.h"

using namespace glimt;
using namespace glimt::test;

namespace {

Scene boxOf(const Material& material) {
  Scene scene;
  addCube(scene, 1, add(scene, lambert("lamp", Vec3(0.4f), Vec3(0.5f))), true);
  addSphere(scene, 0.4f, 1, add(scene, material));
  scene.camera.position = Vec3(0, 0, 0.9f);
  return scene;
}

// A ball under a sky that is brighter on one side.
Scene ballUnderSky(float strength, float rotation) {
  Scene scene;
  addSphere(scene, 0.4f, 1, add(scene, lambert("ball", Vec3(0.6f))));
  scene.environment.image = {2, 1, {Vec3(0.1f), Vec3(1)}};
  scene.environment.strength = strength;
  scene.environment.rotation = rotation;
  scene.camera.position = Vec3(0, 0, 2);
  return scene;
}

Image samplesOf(Renderer& renderer) {
  while (renderer.samples() < 4) renderer.renderSample();
  return renderer.radiance();
}

}  // namespace

TEST_CASE("with exchanged materials the picture is that of a renderer of their own, bit for bit") {
  Material coated = lambert("ball", Vec3(0.7f, 0.1f, 0.1f));
  coated.clearcoat = 1;
  Material glass = lambert("ball", Vec3(1));
  glass.roughness = 0;
  glass.specular = 1;
  glass.transmission = 1;
  const Scene plain = boxOf(lambert("ball", Vec3(0.2f, 0.7f, 0.2f)));
  Scene seen = boxOf(coated);
  seen.transparent_background = true;
  const std::vector<Scene> scenes{boxOf(coated), seen, boxOf(glass), plain};
  const MaterialChange change = GENERATE(MaterialChange::any, MaterialChange::numbers);
  std::vector<Image> own;
  for (const Scene& scene : scenes) own.push_back(render(scene, settingsFor(24, 3), 4));
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, plain, settingsFor(24, 3));
  samplesOf(renderer);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    CAPTURE(i);
    renderer.setMaterials(scenes[i], change);
    const Image exchanged = samplesOf(renderer);
    CHECK(identical(exchanged, own[i]));
    CHECK(exchanged.alpha == own[i].alpha);
  }
}

TEST_CASE("a sky that is turned, put out and lit again is that of a renderer of its own") {
  const std::vector<Scene> scenes{ballUnderSky(1, 70), ballUnderSky(0, 70), ballUnderSky(2.5f, 20)};
  std::vector<Image> own;
  for (const Scene& scene : scenes) own.push_back(render(scene, settingsFor(24, 2), 4));
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, ballUnderSky(1, 0), settingsFor(24, 2));
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    CAPTURE(i);
    renderer.setMaterials(scenes[i], MaterialChange::numbers);
    CHECK(identical(samplesOf(renderer), own[i]));
  }
}

TEST_CASE("materials of triangles that are elsewhere are refused, and nothing changes") {
  const Scene scene = boxOf(lambert("ball", Vec3(0.5f)));
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, scene, settingsFor(16, 1));
  const Image before = samplesOf(renderer);
  Scene moved = scene;
  moved.positions.back().x += 0.1f;
  CHECK_THAT(messageOf(ErrorKind::usage, [&] { renderer.setMaterials(moved); }),
             Catch::Contains("another renderer"));
  Scene fewer = scene;
  fewer.triangles.pop_back();
  messageOf(ErrorKind::usage, [&] { renderer.setMaterials(fewer); });
  CHECK(identical(before, samplesOf(renderer)));
}
