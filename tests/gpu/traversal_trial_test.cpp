// What `auto` finds out while it renders: which of its traversals is the fastest.
#include <array>
#include <catch2/catch.hpp>

#include "renderer/gl/device.h"
#include "renderer/passes/path_tracer.h"
#include "renderer/passes/traversal_trial.h"
#include "renderer/renderer.h"
#include "tests/image/scenes.h"

using namespace glimt;

namespace {

// Samples that take `seconds[i]` with the i-th of "a", "b" until the trial has ended; returns with
// how many of the first the picture began.
int run(TraversalTrial& trial, const std::array<double, 2>& seconds) {
  int before = 0;
  bool begun = false;
  for (int sample = 0; sample < 1000 && trial.times().empty(); ++sample) {
    const bool first = trial.traversal() == "a";
    begun = begun || !first;
    if (!begun) ++before;
    trial.add(seconds[first ? 0 : 1]);
  }
  return before;
}

std::string chosenOf(double a, double b) {
  TraversalTrial trial({"a", "b"});
  run(trial, {a, b});
  REQUIRE(trial.times().size() == 2);
  CHECK(trial.times()[0].seconds_per_sample == a);
  CHECK(trial.times()[1].seconds_per_sample == b);
  return trial.traversal();
}

// A shining sphere in a box.
Scene lampInBox() {
  Scene scene;
  test::addCube(scene, 1, test::add(scene, test::lambert("wall", Vec3(0.8f, 0.5f, 0.3f))), true);
  test::addSphere(scene, 0.3f, 3, test::add(scene, test::lambert("lamp", Vec3(0), Vec3(5))));
  scene.camera.position = Vec3(0.3f, 0.2f, 0.9f);
  return scene;
}

std::vector<Vec3> pictureOf(gl::Device& device, bool switched) {
  PathTracer tracer(device, lampInBox(), {2, 0, "auto"});
  tracer.resize(64, 64);
  REQUIRE(tracer.candidates().size() > 1);
  while (tracer.samples() < 4) {
    tracer.drawTile(1e9);
    if (switched && tracer.atSampleStart())
      tracer.use(tracer.candidates()[static_cast<std::size_t>(tracer.samples()) % 2]);
  }
  std::vector<Vec3> picture;
  for (const Vec4& texel : tracer.accumulation().readMean()) picture.emplace_back(texel);
  return picture;
}

}  // namespace

TEST_CASE("the faster traversal is taken, in a tie the first") {
  CHECK(chosenOf(0.2, 0.1) == "b");
  CHECK(chosenOf(0.1, 0.2) == "a");
  CHECK(chosenOf(0.100, 0.099) == "a");
}

TEST_CASE("a trial begins after two seconds and no less than five samples") {
  TraversalTrial quick({"a", "b"});
  CHECK(run(quick, {0.01, 0.01}) == 200);
  TraversalTrial slow({"a", "b"});
  CHECK(run(slow, {3, 3}) == 5);
}

TEST_CASE("one slow sample, as the first or one that was disturbed, does not decide a trial") {
  TraversalTrial trial({"a", "b"});
  for (int sample = 0; trial.times().empty(); ++sample)
    trial.add(trial.traversal() == "a" ? 0.5 : sample % 2 == 0 ? 9 : 0.3);
  CHECK(trial.traversal() == "b");
}

TEST_CASE("another picture starts the trial again, unless it has ended") {
  TraversalTrial trial({"a", "b"});
  while (trial.traversal() == "a") trial.add(0.5);
  trial.restart();
  CHECK(trial.traversal() == "a");
  run(trial, {0.5, 0.4});
  trial.restart();
  CHECK(trial.traversal() == "b");
}

TEST_CASE("a traversal alone is not tried") {
  TraversalTrial trial({"a"});
  for (int sample = 0; sample < 100; ++sample) trial.add(1);
  CHECK(trial.times().empty());
}

TEST_CASE("traversals that take turns give the picture of one alone") {
  ContextHandle context = createOffscreenContext(Backend::automatic, 2);
  gl::Device device(context.get());
  CHECK(pictureOf(device, true) == pictureOf(device, false));
}
