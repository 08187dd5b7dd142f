#include "renderer/scene/effects_of.h"

#include <catch2/catch.hpp>

using namespace glimt;

namespace {

// `count` triangles of one grey material.
Scene sceneOf(std::size_t count) {
  Scene scene;
  scene.materials.resize(2);
  scene.materials[1].emission = Vec3(0, 2, 0);
  scene.triangles.resize(count);
  return scene;
}

EffectReport reportOn(const Scene& scene, Effect effect) {
  for (const EffectReport& report : reportEffects(scene)) {
    if (report.effect == effect) return report;
  }
  FAIL("the effect is not reported");
  return {};
}

EffectSet set(std::initializer_list<Effect> effects) {
  EffectSet result;
  for (const Effect effect : effects) result.set(static_cast<std::size_t>(effect));
  return result;
}

}  // namespace

TEST_CASE("every effect is reported once, on or off, with its name and a reason") {
  const std::vector<EffectReport> reports = reportEffects(sceneOf(1));
  REQUIRE(reports.size() == kEffectCount);
  EffectSet seen;
  for (const EffectReport& report : reports) {
    CHECK_FALSE(seen[static_cast<std::size_t>(report.effect)]);
    seen.set(static_cast<std::size_t>(report.effect));
    CHECK_FALSE(report.name.empty());
    CHECK_FALSE(report.reason.empty());
  }
}

TEST_CASE("a plain scene calls for no effect") {
  CHECK(effectsOf(sceneOf(3)).none());
  CHECK(effectsOf(Scene{}).none());
  CHECK(reportOn(sceneOf(3), Effect::triangle_lights).reason == "no triangle emits");
  CHECK(reportOn(sceneOf(3), Effect::environment).reason == "its radiance is zero");
  CHECK(reportOn(sceneOf(3), Effect::smooth_normals).reason == "no triangle has normals");
}

TEST_CASE("triangles that emit turn on triangle_lights and nothing else") {
  Scene scene = sceneOf(4);
  scene.triangles[0].material = 1;
  CHECK(reportOn(scene, Effect::triangle_lights).reason == "1 triangle emits");
  scene.triangles[2].material = 1;
  const EffectReport report = reportOn(scene, Effect::triangle_lights);
  CHECK(report.on);
  CHECK(report.name == "triangle_lights");
  CHECK(report.reason == "2 triangles emit");
  CHECK(has(effectsOf(scene), Effect::triangle_lights));
  CHECK(effectsOf(scene).count() == 1);
}

TEST_CASE("an emitting material that no triangle has is no light") {
  CHECK_FALSE(has(effectsOf(sceneOf(4)), Effect::triangle_lights));
}

TEST_CASE("the environment is on when its radiance is not zero in all channels") {
  Scene scene = sceneOf(1);
  scene.environment.color = Vec3(1);
  scene.environment.strength = 0.5f;
  CHECK(reportOn(scene, Effect::environment).on);
  CHECK(reportOn(scene, Effect::environment).reason == "environment radiance is (0.5, 0.5, 0.5)");
  scene.environment.color = Vec3(0, 0, 1e-6f);
  CHECK(has(effectsOf(scene), Effect::environment));
  scene.environment.strength = 0;
  CHECK_FALSE(has(effectsOf(scene), Effect::environment));
}

TEST_CASE("smooth_normals is on when at least one triangle has normals, and says how many have") {
  Scene scene = sceneOf(5000);
  for (std::size_t i = 0; i < 1234; ++i) scene.triangles[i].normals = {0, 0, 0};
  const EffectReport report = reportOn(scene, Effect::smooth_normals);
  CHECK(report.on);
  CHECK(report.reason == "1,234 of 5,000 triangles have normals");
}

TEST_CASE("an environment's picture turns on environment_map, unless there is no light in it") {
  Scene scene = sceneOf(1);
  scene.environment.color = Vec3(1);
  CHECK(reportOn(scene, Effect::environment_map).reason == "the environment is one colour");
  scene.environment.image = {2, 1, {Vec3(0), Vec3(1)}};
  CHECK(has(effectsOf(scene), Effect::environment));
  CHECK(reportOn(scene, Effect::environment_map).reason == "a picture of 2 x 1 pixels");
  scene.environment.image.pixels[1] = Vec3(0);
  CHECK(effectsOf(scene).none());
}

TEST_CASE("a material turns on the one effect that it is, when a triangle has it") {
  struct Case {
    float metallic, roughness, specular, transmission;
    Effect effect;
  };
  const std::string name = "thing";
  for (const Case& c :
       {Case{1, 0.5f, 0, 0, Effect::gloss}, Case{0, 1, 1, 0, Effect::gloss},
        Case{1, 0, 0, 0, Effect::mirror}, Case{0, 0, 1, 0, Effect::mirror},
        Case{0, 0, 1, 1, Effect::glass}, Case{0, 0.2f, 1, 1, Effect::rough_glass}}) {
    Scene scene = sceneOf(2);
    scene.materials[1] = Material();
    scene.materials[1].name = name;
    scene.materials[1].metallic = c.metallic;
    scene.materials[1].roughness = c.roughness;
    scene.materials[1].specular = c.specular;
    scene.materials[1].transmission = c.transmission;
    CHECK(effectsOf(scene).none());
    scene.triangles[1].material = 1;
    CHECK(effectsOf(scene).count() == 1);
    CHECK(reportOn(scene, c.effect).on);
    CHECK_THAT(reportOn(scene, c.effect).reason, Catch::EndsWith("'thing'"));
  }
}

TEST_CASE("a light that shines turns on punctual_lights and nothing else") {
  Scene scene = sceneOf(1);
  scene.lights.resize(2);
  scene.lights[1].intensity = Vec3(0);
  CHECK(reportOn(scene, Effect::punctual_lights).reason == "1 light shines");
  CHECK(effectsOf(scene).count() == 1);
  scene.lights[0].intensity = Vec3(0);
  CHECK(effectsOf(scene).none());
}

TEST_CASE("light samples are chosen among where lights are many or the environment is a picture") {
  Scene scene = sceneOf(1);
  scene.lights.resize(6);
  CHECK(reportOn(scene, Effect::many_lights).reason == "6 lights are few");
  CHECK_FALSE(reportOn(scene, Effect::many_lights).on);
  scene.lights.resize(7);
  CHECK(reportOn(scene, Effect::many_lights).reason == "7 lights are many");
  CHECK(has(effectsOf(scene), Effect::many_lights));

  scene.lights.clear();
  scene.environment.color = Vec3(1);
  CHECK_FALSE(reportOn(scene, Effect::many_lights).on);
  scene.environment.image = {2, 1, {Vec3(0), Vec3(1)}};
  CHECK(reportOn(scene, Effect::many_lights).on);
}

TEST_CASE("a camera turns on the one effect that it is, in the scene and when it is exchanged") {
  Scene scene = sceneOf(1);
  scene.camera.aperture_radius = 0.5f;
  CHECK(effectsOf(scene).count() == 1);
  CHECK(reportOn(scene, Effect::lens).on);
  CHECK(withCamera(EffectSet(), scene.camera) == effectsOf(scene));
  const EffectSet lens = effectsOf(scene);
  scene.camera.orthographic_height = 1;
  CHECK(effectsOf(scene).count() == 1);
  CHECK(reportOn(scene, Effect::orthographic).on);
  CHECK(withCamera(lens, scene.camera) == effectsOf(scene));
  CHECK(withCamera(lens, Camera()).none());
}

TEST_CASE("pictures, vertex colours, alpha and unlit surfaces are effects of materials in use") {
  Scene scene = sceneOf(1);
  scene.images.resize(1);
  scene.materials[1].base_color_texture.image = 0;
  CHECK(effectsOf(scene).none());  // no triangle has it
  scene.materials[0].normal_texture.image = 0;
  CHECK(has(effectsOf(scene), Effect::textures));
  CHECK(has(effectsOf(scene), Effect::normal_maps));
  scene.triangles[0].colors.fill(0);
  CHECK(has(effectsOf(scene), Effect::vertex_colors));
  scene.materials[0].alpha_mode = AlphaMode::mask;
  CHECK(has(effectsOf(scene), Effect::alpha));
  scene.materials[0].emission_texture.image = 0;
  CHECK_FALSE(has(effectsOf(scene), Effect::emission_textures));  // of a surface that is dark
  scene.materials[0].emission = Vec3(1);
  CHECK(has(effectsOf(scene), Effect::emission_textures));
  CHECK(has(effectsOf(scene), Effect::triangle_lights));
  scene.materials[0].unlit = true;
  CHECK(has(effectsOf(scene), Effect::unlit));
  CHECK_FALSE(has(effectsOf(scene), Effect::triangle_lights));
}

TEST_CASE("coats, fibres, thin walls and absorption turn on their effect, where light gets there") {
  Scene scene = sceneOf(2);
  Material& material = scene.materials[scene.triangles[1].material];
  material = Material();
  material.thin_walled = true;
  material.attenuation_color = Vec3(0.5f);
  material.attenuation_distance = 1;
  CHECK(effectsOf(scene).none());
  material.transmission = 1;
  CHECK(reportOn(scene, Effect::thin_walls).on);
  CHECK_FALSE(reportOn(scene, Effect::absorption).on);
  material.thin_walled = false;
  CHECK_FALSE(reportOn(scene, Effect::thin_walls).on);
  CHECK(reportOn(scene, Effect::absorption).on);
  material = Material();
  material.clearcoat = 0.1f;
  CHECK(reportOn(scene, Effect::clearcoat).on);
  CHECK(effectsOf(scene).count() == 1);
  material = Material();
  material.sheen_color = Vec3(0, 0.1f, 0);
  CHECK(reportOn(scene, Effect::sheen).on);
  CHECK(effectsOf(scene).count() == 1);
}

TEST_CASE("an effect brings what it implies, and only that") {
  CHECK(withImplied(set({Effect::environment_map})) ==
        set({Effect::environment_map, Effect::environment}));
  CHECK(withImplied(set({Effect::normal_maps})) == set({Effect::normal_maps, Effect::textures}));
  CHECK(withImplied(set({Effect::emission_textures})) ==
        set({Effect::emission_textures, Effect::textures, Effect::triangle_lights}));
  CHECK(withImplied(set({Effect::emission_textures, Effect::unlit})) ==
        set({Effect::emission_textures, Effect::unlit, Effect::textures}));
  CHECK(withImplied(set({Effect::absorption})) == set({Effect::absorption, Effect::glass}));
  const EffectSet rough_and_thin = set({Effect::rough_glass, Effect::thin_walls});
  CHECK(withImplied(rough_and_thin) == rough_and_thin);
  CHECK(withImplied(set({Effect::lens, Effect::orthographic})) == set({Effect::orthographic}));
}

TEST_CASE("an effect that is withheld takes those with it that imply it") {
  const EffectSet textured = set({Effect::textures, Effect::normal_maps, Effect::gloss});
  CHECK(without(textured, set({Effect::textures})) == set({Effect::gloss}));
  CHECK(without(textured, set({Effect::normal_maps})) == set({Effect::textures, Effect::gloss}));
  CHECK(without(textured, set({Effect::mirror})) == textured);
  const EffectSet glass = set({Effect::glass, Effect::absorption, Effect::thin_walls});
  CHECK(without(glass, set({Effect::glass})).none());
  const EffectSet both = glass | set({Effect::rough_glass});
  CHECK(without(both, set({Effect::glass})) ==
        set({Effect::rough_glass, Effect::absorption, Effect::thin_walls}));
  CHECK(changed(glass, {set({Effect::lens}), set({Effect::absorption})}) ==
        set({Effect::glass, Effect::thin_walls, Effect::lens}));
}

TEST_CASE("effects are forced upon a scene beside its own, and its camera stays what it is") {
  Scene scene = sceneOf(1);
  const EffectSet all = EffectSet().set();
  CHECK(withForced(effectsOf(scene), {}) == effectsOf(scene));
  CHECK_FALSE(has(withForced(effectsOf(scene), all), Effect::orthographic));
  // Nor is it with a background that it does not have.
  CHECK_FALSE(has(withForced(effectsOf(scene), all), Effect::transparent_background));
  CHECK_FALSE(has(withForced(effectsOf(scene), all), Effect::shadow_catcher));
  CHECK(withForced(effectsOf(scene), all).count() == kEffectCount - 3);
  scene.camera.orthographic_height = 1;
  CHECK(has(withForced(effectsOf(scene), all), Effect::orthographic));
  CHECK_FALSE(has(withForced(effectsOf(scene), all), Effect::lens));
}
