// What the viewer renders to a file beside the window.
#include "app/viewer/beside_work.h"

#include <catch2/catch.hpp>
#include <memory>

#include "app/viewer/background_task.h"
#include "renderer/core/image_file.h"
#include "tests/image/pictures.h"
#include "tests/image/scenes.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;

namespace {

BesidePicture picture(int width, int height) {
  Scene scene = test::furnace(0.5f);
  const Look look = lookOf(scene, "", 1, 0, Tone::srgb);
  const Camera camera = scene.camera;
  Tree tree(scene);
  RenderSettings settings = test::settingsFor(1, 1);
  settings.width = width;
  settings.height = height;
  return {{std::make_shared<const LoadedScene>(
               LoadedScene{{}, std::move(scene), std::move(tree), 0, {}}),
           look},
          camera,
          settings,
          2};
}

}  // namespace

TEST_CASE("a picture beside the window has the size that was asked for, whatever the window's") {
  const TemporaryFolder folder;
  const auto file = folder / "picture.exr";
  float progress = 0;
  renderToFile(picture(24, 10), 3, file, [&](float fraction) { progress = fraction; });
  const Image image = readImage(file);
  CHECK(image.width == 24);
  CHECK(image.height == 10);
  CHECK(progress == 1);
}

TEST_CASE("a picture beside the window that is cancelled leaves no file") {
  const TemporaryFolder folder;
  const auto file = folder / "picture.png";
  const WorkProgress cancel = [](float) { throw Cancelled(); };
  CHECK_THROWS_AS(renderToFile(picture(24, 10), 100, file, cancel), Cancelled);
  CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("what effects cost is told of those that the look calls for, as shares of the time") {
  BesidePicture coated = picture(64, 64);
  coated.view.look.materials.front().clearcoat = 1;
  const EffectCosts costs = effectCostsOf(coated, [](float) {});
  CHECK(costs.count("clearcoat") == 1);
  CHECK(costs.count("triangle_lights") == 1);
  CHECK(costs.count("glass") == 0);
  for (const auto& [effect, share] : costs) {
    CAPTURE(effect);
    CHECK(share < 1);
  }
}
