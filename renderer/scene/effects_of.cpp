#include "renderer/scene/effects_of.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/core/wording.h"
#include "renderer/scene/texture_uses.h"
#include "renderer/scene/transmission.h"

namespace glimt {
namespace {

bool anyPositive(const Vec3& v) {
  return v.x > 0 || v.y > 0 || v.z > 0;
}

std::size_t emittingTriangles(const Scene& scene) {
  const auto emits = [&scene](const Triangle& triangle) {
    const Material& material = scene.materials[triangle.material];
    return !material.unlit && anyPositive(material.emission);
  };
  return static_cast<std::size_t>(
      std::count_if(scene.triangles.begin(), scene.triangles.end(), emits));
}

std::size_t shiningLights(const Scene& scene) {
  const auto shines = [](const PunctualLight& light) { return anyPositive(light.intensity); };
  return static_cast<std::size_t>(std::count_if(scene.lights.begin(), scene.lights.end(), shines));
}

EffectReport reportTriangleLights(const Scene& scene) {
  const std::size_t count = emittingTriangles(scene);
  const std::string reason =
      count == 0 ? "no triangle emits"
                 : fmt::format("{} emit{}", counted(count, "triangle"), count == 1 ? "s" : "");
  return {Effect::triangle_lights, "triangle_lights", count > 0, reason};
}

EffectReport reportEnvironment(const Scene& scene) {
  const Environment& environment = scene.environment;
  const Vec3 radiance = environment.radiance();
  std::string reason = "its radiance is zero";
  if (environment.shines())
    reason = environment.image.pixels.empty()
                 ? fmt::format("environment radiance is ({:g}, {:g}, {:g})", radiance.x, radiance.y,
                               radiance.z)
                 : "it has a picture";
  return {Effect::environment, "environment", environment.shines(), reason};
}

EffectReport reportEnvironmentMap(const Scene& scene) {
  const Image& image = scene.environment.image;
  const bool on = scene.environment.shines() && !image.pixels.empty();
  std::string reason = "no light comes from outside";
  if (on)
    reason = fmt::format("a picture of {} x {} pixels", image.width, image.height);
  else if (scene.environment.shines())
    reason = "the environment is one colour";
  return {Effect::environment_map, "environment_map", on, reason};
}

EffectReport reportSmoothNormals(const Scene& scene) {
  const auto count = std::count_if(scene.triangles.begin(), scene.triangles.end(),
                                   [](const Triangle& triangle) { return triangle.smooth(); });
  const std::string reason =
      count == 0 ? "no triangle has normals"
                 : fmt::format("{} of {} {} normals", grouped(static_cast<std::size_t>(count)),
                               counted(scene.triangles.size(), "triangle"),
                               scene.triangles.size() == 1 ? "has" : "have");
  return {Effect::smooth_normals, "smooth_normals", count > 0, reason};
}

// On where a material that triangles have is one of those; `which` says what they are.
EffectReport reportMaterials(const Scene& scene, Effect effect, bool (*is)(const Material&),
                             const std::string& which) {
  std::vector<bool> used(scene.materials.size());
  for (const Triangle& triangle : scene.triangles) used[triangle.material] = true;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i] && is(scene.materials[i])) names.push_back(scene.materials[i].name);
  const std::string reason = names.empty() ? fmt::format("no material is {}", which)
                                           : fmt::format("{}: {}", which, listed(names));
  return {effect, nameOf(effect), !names.empty(), reason};
}

EffectReport reportVertexColors(const Scene& scene) {
  const auto count = std::count_if(scene.triangles.begin(), scene.triangles.end(),
                                   [](const Triangle& triangle) { return triangle.colored(); });
  const std::string reason =
      count == 0 ? "no triangle has colours"
                 : fmt::format("of {}", counted(static_cast<std::size_t>(count), "triangle"));
  return {Effect::vertex_colors, nameOf(Effect::vertex_colors), count > 0, reason};
}

bool looksUp(const Material& material) {
  for (const TextureUse* use : usesOf(material))
    if (use->used()) return true;
  return false;
}

bool reflects(const Material& material) {
  return !material.unlit &&
         (material.metallic > 0 || (material.specular > 0 && material.transmission < 1));
}

EffectReport reportPunctualLights(const Scene& scene) {
  const std::size_t count = shiningLights(scene);
  const std::string reason =
      count == 0 ? "no light without triangles shines" : counted(count, "light") + " shine";
  return {Effect::punctual_lights, "punctual_lights", count > 0,
          count == 1 ? reason + "s" : reason};
}

EffectReport reportManyLights(const Scene& scene) {
  // A rectangle is two triangles. Among few the brightest is nearly always taken, and where it is
  // hidden, the light of the others would be found by chance.
  constexpr std::size_t kFew = 6;
  const std::size_t count = emittingTriangles(scene) + shiningLights(scene);
  const bool many = count > kFew;
  if (reportEnvironmentMap(scene).on)
    return {Effect::many_lights, nameOf(Effect::many_lights), true, "the environment is a picture"};
  return {Effect::many_lights, nameOf(Effect::many_lights), many,
          fmt::format("{} {} {}", counted(count, "light"), count == 1 ? "is" : "are",
                      many ? "many" : "few")};
}

EffectReport reportTransparentBackground(const Scene& scene) {
  const bool on = scene.transparent_background;
  return {Effect::transparent_background, nameOf(Effect::transparent_background), on,
          on ? "the background is transparent" : "the background is what the camera sees there"};
}

EffectReport reportLens(const Camera& camera) {
  std::string reason = "all is sharp: the camera's aperture is a point";
  if (camera.orthographic_height > 0)
    reason = "the projection is parallel";
  else if (camera.aperture_radius > 0)
    reason = fmt::format("an aperture of radius {:g} m, sharp at {:g} m", camera.aperture_radius,
                         camera.focus_distance);
  return {Effect::lens, "lens", camera.aperture_radius > 0 && !(camera.orthographic_height > 0),
          reason};
}

EffectReport reportOrthographic(const Camera& camera) {
  const bool on = camera.orthographic_height > 0;
  return {Effect::orthographic, "orthographic", on,
          on ? fmt::format("a parallel projection, {:g} m high", camera.orthographic_height)
             : "the projection is central"};
}

}  // namespace

std::vector<EffectReport> reportEffects(const Scene& scene) {
  const auto gloss = [](const Material& m) { return reflects(m) && m.roughness > 0; };
  const auto mirror = [](const Material& m) { return reflects(m) && m.roughness == 0; };
  const auto glass = [](const Material& m) { return transmits(m) && m.roughness == 0; };
  const auto absorbs = [](const Material& m) { return absorptionOf(m) != Vec3(0); };
  const auto coated = [](const Material& m) { return !m.unlit && m.clearcoat > 0; };
  const auto fibrous = [](const Material& m) { return !m.unlit && anyPositive(m.sheen_color); };
  const auto thin = [](const Material& m) { return transmits(m) && m.thin_walled; };
  const auto rough_glass = [](const Material& m) { return transmits(m) && m.roughness > 0; };
  const auto emits_texture = [](const Material& m) {
    const Material shaded = shadedAs(m);
    return shaded.emission_texture.used() && anyPositive(shaded.emission);
  };
  const auto normal_map = [](const Material& m) { return m.normal_texture.used(); };
  const auto passable = [](const Material& m) { return m.alpha_mode != AlphaMode::opaque; };
  const auto catches = [](const Material& m) { return m.shadow_catcher; };
  const auto unlit = [](const Material& m) { return m.unlit; };
  EffectReport catchers =
      reportMaterials(scene, Effect::shadow_catcher, catches, "a shadow catcher");
  if (catchers.on && !scene.transparent_background) {
    catchers.on = false;
    catchers.reason = "the background is not transparent";
  }
  return {
      reportTriangleLights(scene),
      reportEnvironment(scene),
      reportEnvironmentMap(scene),
      reportSmoothNormals(scene),
      reportMaterials(scene, Effect::gloss, gloss, "rough and reflecting"),
      reportMaterials(scene, Effect::mirror, mirror, "smooth and reflecting"),
      reportMaterials(scene, Effect::glass, glass, "smooth and transmitting"),
      reportMaterials(scene, Effect::rough_glass, rough_glass, "rough and transmitting"),
      reportMaterials(scene, Effect::thin_walls, thin, "thin-walled and transmitting"),
      reportMaterials(scene, Effect::absorption, absorbs, "absorbing inside"),
      reportMaterials(scene, Effect::clearcoat, coated, "under a clear coat"),
      reportMaterials(scene, Effect::sheen, fibrous, "covered by fibres"),
      reportMaterials(scene, Effect::textures, looksUp, "textured"),
      reportMaterials(scene, Effect::emission_textures, emits_texture, "emitting with a texture"),
      reportMaterials(scene, Effect::normal_maps, normal_map, "normal-mapped"),
      reportVertexColors(scene),
      reportMaterials(scene, Effect::alpha, passable, "letting light pass"),
      reportMaterials(scene, Effect::unlit, unlit, "unlit"),
      reportPunctualLights(scene),
      reportManyLights(scene),
      reportLens(scene.camera),
      reportOrthographic(scene.camera),
      reportTransparentBackground(scene),
      catchers};
}

EffectSet effectsOf(const Scene& scene) {
  EffectSet effects;
  for (const EffectReport& report : reportEffects(scene)) {
    effects[static_cast<std::size_t>(report.effect)] = report.on;
  }
  return effects;
}

EffectSet withImplied(EffectSet effects) {
  const auto on = [&](Effect effect) { return has(effects, effect); };
  const auto set = [&](Effect effect, bool value) {
    effects.set(static_cast<std::size_t>(effect), value);
  };
  if (on(Effect::environment_map)) set(Effect::environment, true);
  if (on(Effect::normal_maps) || on(Effect::emission_textures)) set(Effect::textures, true);
  if (on(Effect::emission_textures) && !on(Effect::unlit)) set(Effect::triangle_lights, true);
  const bool passes = on(Effect::glass) || on(Effect::rough_glass);
  if ((on(Effect::thin_walls) || on(Effect::absorption)) && !passes) set(Effect::glass, true);
  if (on(Effect::orthographic)) set(Effect::lens, false);
  if (on(Effect::shadow_catcher)) set(Effect::transparent_background, true);
  return effects;
}

EffectSet changeable(EffectSet effects) {
  for (const Effect effect :
       {Effect::orthographic, Effect::transparent_background, Effect::shadow_catcher})
    effects.reset(static_cast<std::size_t>(effect));
  return effects;
}

EffectSet withForced(const EffectSet& effects, const EffectSet& forced) {
  return withImplied(effects | changeable(forced));
}

EffectSet without(const EffectSet& effects, const EffectSet& withheld) {
  EffectSet rest = effects & ~withheld;
  EffectSet plain;  // that imply nothing themselves, but may keep others from it
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const EffectSet alone = EffectSet().set(i);
    if (rest[i] && withImplied(alone) == alone) plain |= alone;
  }
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const EffectSet implied = withImplied(plain | EffectSet().set(i));
    if ((implied & withheld).any()) rest.reset(i);
  }
  return rest;
}

EffectSet changed(const EffectSet& effects, const EffectChange& change) {
  return without(withForced(effects, change.forced), change.withheld);
}

EffectSet withCamera(EffectSet effects, const Camera& camera) {
  for (const EffectReport& report : {reportLens(camera), reportOrthographic(camera)})
    effects[static_cast<std::size_t>(report.effect)] = report.on;
  return effects;
}

}  // namespace glimt
