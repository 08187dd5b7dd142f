#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/json_output.h"
#include "renderer/core/bounds.h"
#include "renderer/core/wording.h"
#include "renderer/scene/default_bounces.h"
#include "renderer/scene/effects_of.h"
#include "renderer/scene/load_scene.h"

namespace glimt {
namespace {

struct Lights {
  std::size_t triangles = 0;
  double area = 0;  // square metres, of one side
};

// Of a place in the coordinates of the scene's file. Where the scene is far from their origin, with
// as many digits as its floats and their distance from there call for.
Json placeJson(const Scene& scene, const Vec3& place) {
  if (scene.origin == glm::dvec3(0)) return jsonOf(place);
  const glm::dvec3 p = scene.origin + glm::dvec3(place);
  Json json = Json::array();
  for (int axis = 0; axis < 3; ++axis) json.push_back(Json::parse(fmt::format("{:.12g}", p[axis])));
  return json;
}

Bounds boundsOf(const Scene& scene) {
  Bounds bounds;
  for (const Vec3& position : scene.positions) bounds.include(position);
  return bounds;
}

double areaOf(const Scene& scene, const Triangle& triangle) {
  const auto [a, b, c] = triangle.positions;
  const Vec3& origin = scene.positions[a];
  return 0.5 * glm::length(glm::cross(scene.positions[b] - origin, scene.positions[c] - origin));
}

Lights lightsOf(const Scene& scene) {
  Lights lights;
  for (const Triangle& triangle : scene.triangles) {
    if (scene.materials[triangle.material].emission == Vec3(0)) continue;
    ++lights.triangles;
    lights.area += areaOf(scene, triangle);
  }
  return lights;
}

std::vector<std::size_t> trianglesByMaterial(const Scene& scene) {
  std::vector<std::size_t> counts(scene.materials.size());
  for (const Triangle& triangle : scene.triangles) ++counts[triangle.material];
  return counts;
}

Json materialsOf(const Scene& scene) {
  const std::vector<std::size_t> counts = trianglesByMaterial(scene);
  Json materials = Json::array();
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& material = scene.materials[i];
    materials.push_back({{"name", material.name},
                         {"triangles", counts[i]},
                         {"base_color", jsonOf(material.base_color)},
                         {"emission", jsonOf(material.emission)},
                         {"double_sided", material.double_sided}});
  }
  return materials;
}

std::vector<std::string> cameraNames(const Scene& scene) {
  std::vector<std::string> names;
  for (const NamedCamera& named : scene.cameras) names.push_back(named.name);
  return names;
}

Json texturesOf(const Scene& scene) {
  Json textures = Json::array();
  for (const TextureImage& image : scene.images)
    textures.push_back({{"name", image.name}, {"width", image.width}, {"height", image.height}});
  return textures;
}

Json effectsOnAndOff(const Scene& scene) {
  Json effects = Json::array();
  for (const EffectReport& effect : reportEffects(scene)) {
    effects.push_back({{"name", effect.name}, {"on", effect.on}, {"reason", effect.reason}});
  }
  return effects;
}

// Of a picture, unless --bounces says otherwise.
BounceLimit bouncesOf(const Scene& scene) {
  if (scene.render.bounces) return {*scene.render.bounces, "the scene's file says so"};
  return defaultBounces(effectsOf(scene));
}

Json reportOf(const InfoOptions& options, const Scene& scene) {
  const Bounds bounds = boundsOf(scene);
  const Lights lights = lightsOf(scene);
  const Camera& camera = scene.camera;
  const BounceLimit limit = bouncesOf(scene);
  return {
      {"scene", options.scene.string()},
      {"name", scene.name},
      {"triangles", scene.triangles.size()},
      {"vertices", scene.positions.size()},
      {"materials", materialsOf(scene)},
      {"textures", texturesOf(scene)},
      {"bounds", {{"min", placeJson(scene, bounds.min)}, {"max", placeJson(scene, bounds.max)}}},
      {"camera",
       {{"position", placeJson(scene, camera.position)},
        {"target", placeJson(scene, camera.target)},
        {"up", jsonOf(camera.up)},
        {"vertical_fov", jsonOf(camera.vertical_fov)},
        {"orthographic_height", jsonOf(camera.orthographic_height)},
        {"aperture_radius", jsonOf(camera.aperture_radius)},
        {"focus_distance", jsonOf(camera.focus_distance)}}},
      {"cameras", cameraNames(scene)},
      {"environment",
       {{"color", jsonOf(scene.environment.color)},
        {"strength", jsonOf(scene.environment.strength)}}},
      {"lights",
       {{"triangles", lights.triangles}, {"area", lights.area}, {"others", scene.lights.size()}}},
      {"cameras", cameraNames(scene)},
      {"variants", scene.variants},
      {"effects", effectsOnAndOff(scene)},
      {"bounces", {{"limit", limit.bounces}, {"reason", limit.reason}}},
      {"warnings", scene.warnings}};
}

// --- The same for people ---------------------------------------------------------------------

std::string textOf(const Vec3& v) {
  return fmt::format("({:.5g}, {:.5g}, {:.5g})", v.x, v.y, v.z);
}

std::string placeText(const Scene& scene, const Vec3& place) {
  if (scene.origin == glm::dvec3(0)) return textOf(place);
  const glm::dvec3 p = scene.origin + glm::dvec3(place);
  return fmt::format("({:.12g}, {:.12g}, {:.12g})", p.x, p.y, p.z);
}

class Table {
 public:
  void row(std::string_view label, std::string_view value) {
    text_ += fmt::format("{:<13}{}\n", label, value);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// Files may name anything, at any length.
std::string shownName(const Material& material) {
  return printable(std::string_view(material.name).substr(0, 60));
}

void addMaterials(Table& table, const Scene& scene) {
  const std::vector<std::size_t> counts = trianglesByMaterial(scene);
  table.row("materials", fmt::format("{}", scene.materials.size()));
  std::size_t width = 0;
  for (const Material& material : scene.materials) {
    width = std::max(width, shownName(material).size());
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& material = scene.materials[i];
    const std::string light =
        material.emission == Vec3(0) ? "" : ", emits " + textOf(material.emission);
    table.row("", fmt::format("{:<{}}  {:>8} triangles, colour {}{}", shownName(material), width,
                              counts[i], textOf(material.base_color), light));
  }
}

void addTextures(Table& table, const Scene& scene) {
  if (scene.images.empty()) return;
  table.row("textures", fmt::format("{}", scene.images.size()));
  for (const TextureImage& image : scene.images)
    table.row("", fmt::format("{:>5} x {:<5}  {}", image.width, image.height,
                              printable(std::string_view(image.name).substr(0, 60))));
}

void addEffects(Table& table, const Scene& scene) {
  const std::vector<EffectReport> effects = reportEffects(scene);
  std::size_t width = 0;
  for (const EffectReport& effect : effects) width = std::max(width, effect.name.size());
  std::string_view label = "effects";
  for (const EffectReport& effect : effects) {
    table.row(label, fmt::format("{:<{}}  {:<3}  {}", effect.name, width, effect.on ? "on" : "off",
                                 effect.reason));
    label = "";
  }
}

std::string textOf(const Scene& scene) {
  const Bounds bounds = boundsOf(scene);
  const Lights lights = lightsOf(scene);
  const Camera& camera = scene.camera;
  Table table;
  table.row("name", printable(scene.name));
  table.row("triangles", fmt::format("{}", scene.triangles.size()));
  table.row("vertices", fmt::format("{}", scene.positions.size()));
  if (!bounds.empty())
    table.row("bounds", fmt::format("{} to {}, size {} m", placeText(scene, bounds.min),
                                    placeText(scene, bounds.max), textOf(bounds.size())));
  table.row("camera",
            fmt::format("at {}, looks at {}, up {}, {:.5g} degrees high",
                        placeText(scene, camera.position), placeText(scene, camera.target),
                        textOf(camera.up), camera.vertical_fov));
  if (!scene.cameras.empty()) table.row("cameras", listed(cameraNames(scene)));
  table.row("environment", "radiance " + textOf(scene.environment.radiance()));
  table.row("lights", fmt::format("{} triangles, {:.5g} m^2, {} others", lights.triangles,
                                  lights.area, scene.lights.size()));
  if (!scene.variants.empty()) table.row("variants", listed(scene.variants));
  addMaterials(table, scene);
  addTextures(table, scene);
  addEffects(table, scene);
  const BounceLimit limit = bouncesOf(scene);
  table.row("bounces", fmt::format("{}: {}", limit.bounces, limit.reason));
  for (const std::string& warning : scene.warnings) table.row("warning", warning);
  return table.text();
}

}  // namespace

int runInfo(const InfoOptions& options) {
  checkJsonFile(options.json);
  Scene scene = loadScene(options.scene, options.load);
  scene.camera = cameraOf(options.camera, scene);
  if (options.json.empty()) {
    writeOut(textOf(scene));
  } else {
    writeJson(options.json, reportOf(options, scene));
  }
  return 0;
}

}  // namespace glimt
