// What `glimt render` saves as PNG is what the window shows.
#include "renderer/core/display_transform.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <limits>

#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;

TEST_CASE("the display transform on the CPU is the shader's, to one step of a byte") {
  Scene scene = test::furnace(0.5f);
  ContextHandle context = createOffscreenContext(Backend::automatic, 2);
  Renderer renderer(context, scene, test::settingsFor(32, 1));
  renderer.renderSample();
  const Image radiance = renderer.radiance();
  const Tone tone = GENERATE(Tone::srgb, Tone::agx, Tone::aces);
  CAPTURE(kToneNames[static_cast<std::size_t>(tone)]);
  for (int step = -96; step <= 48; ++step) {
    const float exposure = 0.125f * static_cast<float>(step);
    CAPTURE(exposure);
    const DisplayImage cpu = displayImage(radiance, exposure, tone);
    const DisplayImage shader = renderer.display(exposure, tone);
    REQUIRE(cpu.bytes.size() == shader.bytes.size());
    int worst = 0;
    for (std::size_t i = 0; i < cpu.bytes.size(); ++i)
      worst = std::max(worst, std::abs(cpu.bytes[i] - shader.bytes[i]));
    CHECK(worst <= 1);
  }
}

TEST_CASE("the display transform has its ends where they belong") {
  const float infinity = std::numeric_limits<float>::infinity();
  const Image image{2, 1, {Vec3(0, 1, infinity), Vec3(0.0031308f, -1, 0.5f)}};
  CHECK(displayImage(image, 0).bytes == std::vector<std::uint8_t>{0, 255, 255, 10, 0, 188});
  CHECK(displayImage(image, 1000).bytes == std::vector<std::uint8_t>{0, 255, 255, 255, 0, 255});
}
