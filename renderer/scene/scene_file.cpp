#include "renderer/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "renderer/core/error.h"
#include "renderer/core/wording.h"
#include "renderer/scene/environment_picture.h"
#include "renderer/scene/json_fields.h"
#include "renderer/scene/scene_check.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 16;
constexpr double kLargestFloat = std::numeric_limits<float>::max();

constexpr Range kCoordinate = {-kLargestCoordinate, kLargestCoordinate,
                               "a number of metres between -1e8 and 1e8"};
// Of the file, whose model may be far from its origin; load_scene.cpp asks for less.
constexpr Range kPlace = {-1e15, 1e15, "a number of metres between -1e15 and 1e15"};
constexpr Range kFinite = {-kLargestFloat, kLargestFloat, "a number"};
constexpr Range kPositive = {0, kLargestFloat, "a number that is not negative"};
constexpr Range kUnit = {0, 1, "a number between 0 and 1"};
constexpr Range kIor = {1, 1000, "a number between 1 and 1000"};
constexpr Range kElevation = {0, 90, "a number of degrees between 0 and 90"};
constexpr Range kTurbidity = {2, 10, "a number between 2 and 10"};
constexpr Range kLength = {0, kLargestCoordinate, "a number of metres above 0 and below 1e8", true};
constexpr Range kRadius = {0, kLargestCoordinate, "a number of metres between 0 and 1e8"};
constexpr Range kBlades = {0, 64, "0 for a round one, or an integer from 3 to 64"};
constexpr Range kFov = {0, 180, "a number between 0 and 180", true};
// A size that the command line asks for may be larger: a scene file may come from anyone.
constexpr int kMostPixels = 1 << 26;
constexpr Range kPixels = {1, 16384, "an integer between 1 and 16384"};
constexpr Range kBounces = {0, 1000, "an integer between 0 and 1000"};
constexpr Range kExposure = {-100, 100, "a number between -100 and 100"};

CameraSettings readCamera(const JsonDocument& document, const std::string& name,
                          const nlohmann::json& value) {
  const JsonFields fields(document, name, value,
                          {"position", "target", "up", "vertical_fov", "orthographic_height",
                           "aperture_radius", "focus_distance", "aperture_blades"});
  CameraSettings camera;
  camera.position = fields.point("position", kPlace);
  camera.target = fields.point("target", kPlace);
  camera.up = fields.vector("up", kCoordinate);
  camera.vertical_fov = fields.number("vertical_fov", kFov);
  camera.orthographic_height = fields.number("orthographic_height", kLength);
  camera.aperture_radius = fields.number("aperture_radius", kRadius);
  camera.focus_distance = fields.number("focus_distance", kLength);
  camera.aperture_blades = fields.integer("aperture_blades", kBlades);
  if (camera.aperture_blades == 1 || camera.aperture_blades == 2)
    fields.reject("aperture_blades", kBlades.words);
  if (camera.up == Vec3(0)) fields.reject("up", "a direction");
  if (camera.position && camera.position == camera.target) {
    fields.reject("target", "another point than " + fields.nameOf("position"));
  }
  return camera;
}

SunSky readSunSky(const JsonFields& fields, bool wanted) {
  if (!wanted)
    for (const char* key : {"sun_elevation", "sun_rotation", "turbidity"})
      if (fields.has(key)) fields.reject(key, "left out; only the image \"sun-sky\" has a sun");
  SunSky sky;
  sky.elevation = fields.number("sun_elevation", kElevation).value_or(sky.elevation);
  sky.rotation = fields.number("sun_rotation", kFinite).value_or(sky.rotation);
  sky.turbidity = fields.number("turbidity", kTurbidity).value_or(sky.turbidity);
  return sky;
}

Environment readEnvironment(const JsonFields& fields, const fs::path& folder,
                            std::vector<std::string>& warnings) {
  Environment environment;
  environment.color = fields.vector("color", kPositive).value_or(Vec3(1));
  environment.strength = fields.number("strength", kPositive).value_or(1.0f);
  environment.rotation = fields.number("rotation", kFinite).value_or(0.0f);
  const std::optional<std::string> name = fields.text("image");
  const SunSky sun_sky = readSunSky(fields, name == kSunSkyName);
  if (name) environment.image = environmentPicture(*name, folder, sun_sky, warnings);
  return environment;
}

MaterialSettings readMaterial(std::string name, const JsonFields& fields) {
  MaterialSettings material;
  material.name = std::move(name);
  material.base_color = fields.vector("base_color", kUnit);
  material.emission = fields.vector("emission", kPositive);
  material.double_sided = fields.boolean("double_sided");
  material.metallic = fields.number("metallic", kUnit);
  material.roughness = fields.number("roughness", kUnit);
  material.ior = fields.number("ior", kIor);
  material.transmission = fields.number("transmission", kUnit);
  material.specular = fields.number("specular", kUnit);
  material.thin_walled = fields.boolean("thin_walled");
  material.attenuation_color = fields.vector("attenuation_color", kUnit);
  material.attenuation_distance = fields.number("attenuation_distance", kPositive);
  material.clearcoat = fields.number("clearcoat", kUnit);
  material.clearcoat_roughness = fields.number("clearcoat_roughness", kUnit);
  material.sheen_color = fields.vector("sheen_color", kUnit);
  material.sheen_roughness = fields.number("sheen_roughness", kUnit);
  material.shadow_catcher = fields.boolean("shadow_catcher");
  return material;
}

template <typename T>
void replace(T& value, const std::optional<T>& by) {
  if (by) value = *by;
}

// Whoever speaks of a surface's gloss means one that reflects like a dielectric, or a metal.
void apply(const MaterialSettings& settings, Material& material) {
  replace(material.base_color, settings.base_color);
  replace(material.emission, settings.emission);
  replace(material.double_sided, settings.double_sided);
  replace(material.metallic, settings.metallic);
  replace(material.roughness, settings.roughness);
  replace(material.ior, settings.ior);
  replace(material.transmission, settings.transmission);
  if (settings.metallic || settings.roughness || settings.ior || settings.transmission)
    material.specular = 1;
  replace(material.specular, settings.specular);
  replace(material.thin_walled, settings.thin_walled);
  replace(material.attenuation_color, settings.attenuation_color);
  replace(material.attenuation_distance, settings.attenuation_distance);
  replace(material.clearcoat, settings.clearcoat);
  replace(material.clearcoat_roughness, settings.clearcoat_roughness);
  replace(material.sheen_color, settings.sheen_color);
  replace(material.sheen_roughness, settings.sheen_roughness);
  replace(material.shadow_catcher, settings.shadow_catcher);
}

RenderDefaults readRender(const JsonFields& fields) {
  RenderDefaults render;
  render.size = fields.integers("size", kPixels);
  if (render.size && (*render.size)[0] * (*render.size)[1] > kMostPixels) {
    fields.reject("size", fmt::format("at most {} pixels in all", grouped(kMostPixels)));
  }
  render.bounces = fields.integer("bounces", kBounces);
  render.exposure = fields.number("exposure", kExposure);
  if (const std::optional<std::string> background = fields.text("background")) {
    if (*background != "scene" && *background != "transparent")
      fields.reject("background", "scene or transparent");
    render.transparent_background = *background == "transparent";
  }
  if (const std::optional<std::string> tone = fields.text("tone")) {
    if (std::find(kToneNames.begin(), kToneNames.end(), *tone) == kToneNames.end())
      fields.reject("tone", "srgb, agx or aces");
    render.tone = toneNamed(*tone);
  }
  return render;
}

}  // namespace

SceneFile readSceneFile(const fs::path& path) {
  const JsonDocument document = readJson(path, kDeepest);
  const JsonFields fields(
      document, "", document.value,
      {"model", "variant", "camera", "cameras", "environment", "lights", "materials", "render"});
  SceneFile file;
  const std::optional<std::string> model = fields.text("model");
  if (!model) {
    throw Error(
        ErrorKind::input,
        fmt::format("{}: the key \"model\" is missing; name the .obj, .gltf or .glb to render",
                    printable(path.string())));
  }
  file.model = path.parent_path() / fs::path(*model);
  file.variant = fields.text("variant").value_or("");
  if (const auto* camera = fields.object("camera")) {
    file.camera = readCamera(document, "camera", *camera);
  }
  if (const auto* cameras = fields.object("cameras")) {
    for (const auto& [name, value] : cameras->items())
      file.cameras.push_back(
          {name, readCamera(document, fmt::format("cameras.{}", printable(name)), value)});
  }
  if (const auto* lights = fields.array("lights")) file.lights = readLights(document, *lights);
  if (const auto* environment = fields.object("environment");
      environment && !environment->empty()) {
    file.environment = readEnvironment(JsonFields(document, "environment", *environment,
                                                  {"color", "image", "strength", "rotation",
                                                   "sun_elevation", "sun_rotation", "turbidity"}),
                                       path.parent_path(), file.warnings);
  }
  if (const auto* materials = fields.object("materials")) {
    for (const auto& [name, value] : materials->items()) {
      const JsonFields material(
          document, fmt::format("materials.{}", printable(name)), value,
          {"base_color", "metallic", "roughness", "ior", "transmission", "emission", "double_sided",
           "specular", "thin_walled", "attenuation_color", "attenuation_distance", "clearcoat",
           "clearcoat_roughness", "sheen_color", "sheen_roughness", "shadow_catcher"});
      file.materials.push_back(readMaterial(name, material));
    }
  }
  if (const auto* render = fields.object("render")) {
    file.render = readRender(JsonFields(document, "render", *render,
                                        {"size", "bounces", "exposure", "tone", "background"}));
  }
  return file;
}

void applyMaterials(const SceneFile& file, Scene& scene) {
  std::vector<std::string> unknown;
  std::unordered_map<std::string_view, Material*> material_of_name;
  for (Material& material : scene.materials) material_of_name.try_emplace(material.name, &material);
  for (const MaterialSettings& settings : file.materials) {
    const auto found = material_of_name.find(settings.name);
    if (found == material_of_name.end()) {
      unknown.push_back(settings.name);
      continue;
    }
    apply(settings, *found->second);
  }
  if (!unknown.empty()) {
    std::vector<std::string> known;
    for (const Material& material : scene.materials) known.push_back(material.name);
    scene.warnings.push_back(
        fmt::format("the model has no material {}; it has {}", listed(unknown), listed(known)));
  }
}

}  // namespace glimt
