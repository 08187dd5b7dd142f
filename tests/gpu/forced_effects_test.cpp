// An effect that is compiled and run without being called for takes time, and changes nothing else;
// one that is called for and withheld is not there.
#include <catch2/catch.hpp>

#include <cmath>

#include "renderer/bench/bench_mesh.h"
#include "renderer/bench/picture_comparison.h"
#include "renderer/bench/whole_sample.h"
#include "renderer/scene/effects_of.h"
#include "tests/gpu/contexts.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr int kSide = 24;
constexpr int kSamples = 48;

// Under an even sky: glass, a mirror, a curved metal and a lamp that is a point.
Scene variedScene() {
  Scene scene;
  scene.name = "varied";
  Material glass = lambert("glass", Vec3(0.9f));
  glass.specular = 1;
  glass.roughness = 0;
  glass.transmission = 1;
  Material metal = lambert("metal", Vec3(0.7f, 0.6f, 0.3f));
  metal.metallic = 1;
  metal.roughness = 0.4f;
  addQuad(scene, {-2, -1, -2}, {0, 0, 4}, {4, 0, 0}, add(scene, lambert("floor", Vec3(0.7f))));
  addSphere(scene, 0.6f, 2, add(scene, metal));
  for (Triangle& triangle : scene.triangles) {
    if (triangle.material != 1) continue;
    for (int i = 0; i < 3; ++i) {
      triangle.normals[i] = static_cast<std::uint32_t>(scene.normals.size());
      scene.normals.push_back(glm::normalize(scene.positions[triangle.positions[i]]));
    }
  }
  addQuad(scene, {-1.5f, -0.9f, 0.8f}, {1, 0, 0.2f}, {0, 1, 0}, add(scene, glass));
  scene.lights.resize(1);
  scene.lights[0].position = {1, 2, 1};
  scene.lights[0].intensity = Vec3(3);
  scene.environment.color = {0.3f, 0.4f, 0.6f};
  scene.camera.position = {0, 0.6f, 4};
  return scene;
}

class Tracer {
 public:
  Tracer(const TestContext& context, const Scene& scene, const EffectChange& change)
      : tracer_(context.device(), scene, settingsFor(change)) {
    tracer_.resize(kSide, kSide);
  }

  // Of its next sample.
  std::vector<Vec4> radiance() {
    drawSample(tracer_);
    return tracer_.film().radiance.front().readFloats();
  }

  PathTracer& get() { return tracer_; }

 private:
  static PathTracerSettings settingsFor(const EffectChange& change) {
    PathTracerSettings settings;
    settings.bounces = 2;
    settings.change = change;
    return settings;
  }

  PathTracer tracer_;
};

void checkForced(const TestContext& context, const Scene& scene, const EffectSet& forced) {
  if (withForced(effectsOf(scene), forced) == effectsOf(scene)) return;
  Tracer own(context, scene, {});
  Tracer more(context, scene, {forced, {}});
  // All but one compile more: unlit surfaces emit, and lights do so already.
  const bool emits = forced == EffectSet().set(static_cast<std::size_t>(Effect::unlit)) &&
                     has(effectsOf(scene), Effect::triangle_lights);
  CHECK((own.get().shaders() == more.get().shaders()) == emits);
  PictureComparison comparison;
  for (int sample = 0; sample < kSamples; ++sample) comparison.add(more.radiance(), own.radiance());
  CHECK(comparison.agrees());
  CHECK(comparison.lost() == 0);
}

}  // namespace

TEST_CASE("an effect that is forced on leaves the picture's mean as it is, each and all") {
  const TestContext& context = contexts().front();
  context.makeCurrent();
  for (const Scene& scene : {makeBenchBox(), variedScene()}) {
    for (int i = 0; i < kEffectCount; ++i) {
      CAPTURE(scene.name, nameOf(static_cast<Effect>(i)));
      checkForced(context, scene, EffectSet().set(static_cast<std::size_t>(i)));
    }
    CAPTURE(scene.name);
    checkForced(context, scene, EffectSet().set());
  }
}

TEST_CASE("an effect that is withheld is not compiled, and what is left draws a picture") {
  const TestContext& context = contexts().front();
  context.makeCurrent();
  const auto length = [](PathTracer& tracer) {
    std::size_t sum = 0;
    for (const auto& [pass, text] : tracer.shaders()) sum += text.size();
    return sum;
  };
  Scene scene = variedScene();
  scene.materials[1].clearcoat = 1;
  Tracer own(context, scene, {});
  for (std::size_t i = 0; i < kEffectCount; ++i) {
    if (!effectsOf(scene)[i]) continue;
    CAPTURE(nameOf(static_cast<Effect>(i)));
    Tracer less(context, scene, {{}, EffectSet().set(i)});
    CHECK(length(less.get()) < length(own.get()));
    for (const Vec4& pixel : less.radiance())
      REQUIRE(std::isfinite(pixel.x + pixel.y + pixel.z + pixel.w));
  }
}

TEST_CASE("a lens stays forced on when the camera is exchanged, but not upon a parallel one") {
  const TestContext& context = contexts().front();
  context.makeCurrent();
  const Scene scene = makeBenchBox();
  Tracer tracer(context, scene, {EffectSet().set(static_cast<std::size_t>(Effect::lens)), {}});
  const auto has_lens = [&tracer] {
    return tracer.get().shaders().at("camera").find("lensRay") != std::string::npos;
  };
  CHECK(has_lens());
  Camera camera = scene.camera;
  camera.orthographic_height = 2;
  tracer.get().setCamera(camera);
  CHECK_FALSE(has_lens());
  tracer.get().setCamera(scene.camera);
  CHECK(has_lens());
}
