#include "renderer/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>

#include "renderer/core/error.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"
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
constexpr Range kFov = {0, 180, "a number between 0 and 180", true};
// A size that the command line asks for may be larger: a scene file may come from anyone.
constexpr int kMostPixels = 1 << 26;
constexpr Range kPixels = {1, 16384, "an integer between 1 and 16384"};
constexpr Range kBounces = {0, 1000, "an integer between 0 and 1000"};
constexpr Range kExposure = {-100, 100, "a number between -100 and 100"};

CameraSettings readCamera(const JsonFields& fields) {
  CameraSettings camera;
  camera.position = fields.point("position", kPlace);
  camera.target = fields.point("target", kPlace);
  camera.up = fields.vector("up", kCoordinate);
  camera.vertical_fov = fields.number("vertical_fov", kFov);
  if (camera.up == Vec3(0)) fields.reject("up", "a direction");
  if (camera.position && camera.position == camera.target) {
    fields.reject("target", "another point than camera.position");
  }
  return camera;
}

// What is not a radiance becomes black. True when there was such a pixel.
bool makeSound(Image& image) {
  bool changed = false;
  for (Vec3& pixel : image.pixels)
    for (int c = 0; c < 3; ++c) {
      if (pixel[c] >= 0 && std::isfinite(pixel[c])) continue;
      pixel[c] = 0;
      changed = true;
    }
  return changed;
}

Image readSky(const fs::path& path) {
  try {
    return readImage(path);
  } catch (const Error& error) {
    // Whatever is wrong with it, it is the scene that cannot be used.
    throw Error(ErrorKind::input, error.what());
  }
}

Environment readEnvironment(const JsonFields& fields, const fs::path& folder,
                            std::vector<std::string>& warnings) {
  Environment environment;
  environment.color = fields.vector("color", kPositive).value_or(Vec3(1));
  environment.strength = fields.number("strength", kPositive).value_or(1.0f);
  environment.rotation = fields.number("rotation", kFinite).value_or(0.0f);
  if (const std::optional<std::string> name = fields.text("image")) {
    const fs::path path = folder / fs::path(*name);
    environment.image = readSky(path);
    if (makeSound(environment.image))
      warnings.push_back(
          fmt::format("environment {}: pixels that are negative or not finite are black",
                      printable(path.filename().string())));
  }
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
}

RenderDefaults readRender(const JsonFields& fields) {
  RenderDefaults render;
  render.size = fields.integers("size", kPixels);
  if (render.size && (*render.size)[0] * (*render.size)[1] > kMostPixels) {
    fields.reject("size", fmt::format("at most {} pixels in all", grouped(kMostPixels)));
  }
  render.bounces = fields.integer("bounces", kBounces);
  render.exposure = fields.number("exposure", kExposure);
  return render;
}

}  // namespace

SceneFile readSceneFile(const fs::path& path) {
  const JsonDocument document = readJson(path, kDeepest);
  const JsonFields fields(document, "", document.value,
                          {"model", "camera", "environment", "materials", "render"});
  SceneFile file;
  const std::optional<std::string> model = fields.text("model");
  if (!model) {
    throw Error(ErrorKind::input,
                fmt::format("{}: the key \"model\" is missing; name the .obj to render",
                            printable(path.string())));
  }
  file.model = path.parent_path() / fs::path(*model);
  if (const auto* camera = fields.object("camera")) {
    file.camera = readCamera(
        JsonFields(document, "camera", *camera, {"position", "target", "up", "vertical_fov"}));
  }
  if (const auto* environment = fields.object("environment");
      environment && !environment->empty()) {
    file.environment = readEnvironment(JsonFields(document, "environment", *environment,
                                                  {"color", "image", "strength", "rotation"}),
                                       path.parent_path(), file.warnings);
  }
  if (const auto* materials = fields.object("materials")) {
    for (const auto& [name, value] : materials->items()) {
      const JsonFields material(
          document, fmt::format("materials.{}", printable(name)), value,
          {"base_color", "metallic", "roughness", "ior", "transmission", "emission", "double_sided",
           "specular", "thin_walled", "attenuation_color", "attenuation_distance", "clearcoat",
           "clearcoat_roughness", "sheen_color", "sheen_roughness"});
      file.materials.push_back(readMaterial(name, material));
    }
  }
  if (const auto* render = fields.object("render")) {
    file.render =
        readRender(JsonFields(document, "render", *render, {"size", "bounces", "exposure"}));
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
