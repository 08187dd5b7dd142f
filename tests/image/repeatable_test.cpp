// The same input gives the same picture, whatever draws it and however the work is cut.
#include <catch2/catch.hpp>

#include <iostream>

#include "renderer/core/error.h"
#include "renderer/shader/traversals.h"
#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

// Triangle lights, an environment and smooth normals: every effect there is.
Scene everything() {
  Scene scene;
  addQuad(scene, Vec3(-3, -1, 3), Vec3(6, 0, 0), Vec3(0, 0, -6),
          add(scene, lambert("floor", Vec3(0.6f, 0.7f, 0.8f))));
  addQuad(scene, Vec3(-1, 2, -1), Vec3(2, 0, 0), Vec3(0, 0, 2),
          add(scene, lambert("light", Vec3(0.2f), Vec3(6, 5, 4))));
  const std::size_t first = scene.triangles.size();
  addSphere(scene, 1, 2, add(scene, lambert("ball", Vec3(0.8f, 0.3f, 0.2f))));
  for (std::size_t i = first; i < scene.triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Triangle& triangle = scene.triangles[i];
      triangle.normals[corner] = static_cast<std::uint32_t>(scene.normals.size());
      scene.normals.push_back(glm::normalize(scene.positions[triangle.positions[corner]]));
    }
  }
  scene.environment.color = Vec3(0.2f, 0.3f, 0.5f);
  scene.camera.position = Vec3(2, 1.5f, 4);
  return scene;
}

}  // namespace

TEST_CASE("the same seed gives the same picture, bit for bit, and another seed another one") {
  const Image image = render(everything(), settingsFor(64, 3, 7), 4);
  CHECK(identical(image, render(everything(), settingsFor(64, 3, 7), 4)));
  CHECK_FALSE(identical(image, render(everything(), settingsFor(64, 3, 8), 4)));
}

TEST_CASE("EGL and OSMesa give the same picture, bit for bit") {
  const Image egl = render(everything(), settingsFor(64, 3), 4, Backend::egl);
  try {
    const ContextHandle osmesa = createOffscreenContext(Backend::osmesa, 2);
  } catch (const Error& error) {
    std::cout << "skipped: " << error.what() << "\n";
    return;
  }
  CHECK(identical(egl, render(everything(), settingsFor(64, 3), 4, Backend::osmesa)));
}

TEST_CASE("all traversals give the same picture, bit for bit") {
  ContextHandle context = createOffscreenContext(Backend::egl, 3);
  const auto draw = [&](const std::string& traversal) {
    RenderSettings settings = settingsFor(32, 3);
    settings.traversal = traversal;
    Renderer renderer(context, everything(), settings);
    renderer.renderSample();
    return renderer.radiance();
  };
  const Image image = draw("auto");
  for (const std::string& traversal : traversalNames()) {
    CAPTURE(traversal);
    CHECK(identical(image, draw(traversal)));
  }
}

TEST_CASE("ES 2 and ES 3 contexts give the same picture, bit for bit") {
  const auto draw = [](int gles) {
    ContextHandle context = createOffscreenContext(Backend::egl, gles);
    Renderer renderer(context, everything(), settingsFor(64, 3));
    for (int i = 0; i < 4; ++i) renderer.renderSample();
    return renderer.radiance();
  };
  CHECK(identical(draw(2), draw(3)));
}

TEST_CASE("the picture does not depend on how the work is cut into draws") {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  // So wide that the first draws are parts of a row of tiles, and high enough for several rows.
  RenderSettings settings = settingsFor(2000, 1);
  settings.height = 130;
  Renderer cut(context, everything(), settings);
  while (cut.samples() < 2) cut.advance(0, 2);
  const Image first = cut.radiance();
  // By now the renderer knows that it may draw more at once.
  cut.setCamera(everything().camera);
  cut.advance(1e9, 2);
  CHECK(identical(first, cut.radiance()));
}

TEST_CASE("advance does not go beyond the samples it may make") {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, everything(), settingsFor(16, 1));
  renderer.advance(1e9, 5);
  CHECK(renderer.samples() == 5);
}

TEST_CASE("a new camera and a new size start the picture again") {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  const Scene scene = everything();
  Renderer renderer(context, scene, settingsFor(32, 2));
  const auto sample = [&] {
    renderer.renderSample();
    return renderer.radiance();
  };
  const Image first = sample();
  Camera moved = scene.camera;
  moved.position.x += 1;
  renderer.setCamera(moved);
  CHECK(renderer.samples() == 0);
  CHECK_FALSE(identical(first, sample()));
  renderer.setCamera(scene.camera);
  CHECK(identical(first, sample()));
  renderer.resize(20, 30);
  CHECK(renderer.samples() == 0);
  CHECK(sample().height == 30);
  renderer.resize(32, 32);
  CHECK(identical(first, sample()));
}
