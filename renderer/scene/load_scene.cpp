#include "renderer/scene/load_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "renderer/core/error.h"
#include "renderer/core/wording.h"
#include "renderer/scene/effects_of.h"
#include "renderer/scene/environment_picture.h"
#include "renderer/scene/framing.h"
#include "renderer/scene/gltf_file.h"
#include "renderer/scene/obj_file.h"
#include "renderer/scene/scene_check.h"
#include "renderer/scene/scene_file.h"
#include "renderer/scene/studio.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
  throw Error(ErrorKind::input, fmt::format("{}: {}", printable(path.string()), what));
}

std::string lowerExtension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

bool isSceneFile(const fs::path& path) {
  return lowerExtension(path) == ".json";
}

// OBJ and MTL know no variants.
Scene readObjModel(const fs::path& path, const LoadSettings& settings) {
  if (!settings.variant.empty())
    throw Error(ErrorKind::usage, fmt::format("{}: an OBJ has no variants; leave out --variant",
                                              printable(path.string())));
  return readObjFile(path);
}

bool isGltf(const fs::path& path) {
  const std::string extension = lowerExtension(path);
  return extension == ".gltf" || extension == ".glb";
}

Scene readModel(const fs::path& path, const LoadSettings& settings) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) fail(path, "no such file; check the path");
  const std::string extension = lowerExtension(path);
  if (extension == ".obj") return readObjModel(path, settings);
  if (isGltf(path)) return readGltfFile(path, settings.variant);
  fail(path,
       "unknown kind of model; glimt reads .obj, .gltf and .glb, and .scene.json that names one");
}

// Whether a scene file says where the camera is, or where it looks: then the model's own cameras
// are not asked.
bool placesCamera(const CameraSettings& settings) {
  return settings.position || settings.target || settings.up || settings.vertical_fov;
}

// From the file's coordinates to the scene's.
void movePlace(std::optional<glm::dvec3>& place, const std::string& key, const Scene& scene,
               const fs::path& path) {
  if (!place) return;
  *place -= scene.origin;
  const glm::dvec3 size = glm::abs(*place);
  if (std::max({size.x, size.y, size.z}) > kLargestCoordinate)
    fail(path, fmt::format("{} is farther than 100,000 km from the model; move it closer", key));
}

Camera placedCamera(CameraSettings settings, const std::string& name, const fs::path& path,
                    const Scene& scene) {
  float aspect = 1;
  if (const auto& size = scene.render.size) {
    aspect = static_cast<float>((*size)[0]) / static_cast<float>((*size)[1]);
  }
  movePlace(settings.position, name + ".position", scene, path);
  movePlace(settings.target, name + ".target", scene, path);
  const Camera camera = framed(boundsOf(scene), aspect, settings);
  if (camera.position == camera.target) {
    fail(path, fmt::format("the camera is where it looks; give {0}.position and {0}.target", name));
  }
  return camera;
}

void placeCameras(const SceneFile& file, const fs::path& path, Scene& scene) {
  const bool placed = scene.cameras.empty() || placesCamera(file.camera);
  scene.camera =
      placed ? placedCamera(file.camera, "camera", path, scene) : scene.cameras.front().camera;
  for (const NamedCameraSettings& named : file.cameras)
    scene.cameras.push_back(
        {named.name, placedCamera(named.camera, "cameras." + printable(named.name), path, scene)});
}

void addLights(const SceneFile& file, const fs::path& path, Scene& scene) {
  for (const LightSettings& settings : file.lights) {
    std::optional<glm::dvec3> position = settings.position;
    if (settings.light.kind != PunctualLight::Kind::directional)
      movePlace(position, "lights' position", scene, path);
    scene.lights.push_back(settings.light);
    scene.lights.back().position = Vec3(*position);
  }
}

bool isLit(const Scene& scene) {
  const EffectSet effects = effectsOf(scene);
  return has(effects, Effect::triangle_lights) || has(effects, Effect::environment) ||
         has(effects, Effect::punctual_lights);
}

// glTF says nothing of an environment: it is made to be looked at under whatever light the viewer
// has, and what its surfaces emit is part of their look. Other files that emit light are lit by
// that.
bool wantsStudio(const fs::path& model, const Scene& scene) {
  return !isLit(scene) || (isGltf(model) && scene.lights.empty());
}

void placeEnvironment(const SceneFile& file, const EnvironmentChoice& choice, Scene& scene) {
  Environment& environment = scene.environment;
  if (file.environment) environment = *file.environment;
  if (choice.image) {
    environment = {Vec3(1), 1, environmentPicture(*choice.image, {}, {}, scene.warnings), 0};
  } else if (!file.environment && wantsStudio(file.model, scene)) {
    scene.warnings.push_back(
        isLit(scene)
            ? "no light but what surfaces emit, so a studio lights them; --environment or a "
              "scene file can name another"
            : "nothing gives light, so a studio does; --environment or a scene file can name "
              "another");
    environment = {Vec3(1), 1, makeStudio(), 0};
  }
  if (choice.rotation) environment.rotation = *choice.rotation;
  if (choice.strength) environment.strength = *choice.strength;
  if (!isLit(scene))
    scene.warnings.push_back(
        "nothing gives light: no triangle emits, there are no other lights and the environment is "
        "black; the picture will be black");
}

Scene loadWithin(const fs::path& path, LoadSettings settings) {
  SceneFile file;
  if (isSceneFile(path)) {
    file = readSceneFile(path);
  } else {
    file.model = path;
  }
  if (settings.variant.empty()) settings.variant = file.variant;
  Scene scene = readModel(file.model, settings);
  if (isSceneFile(path)) scene.name = path.stem().stem().string();
  scene.render = file.render;
  scene.warnings.insert(scene.warnings.end(), file.warnings.begin(), file.warnings.end());
  applyMaterials(file, scene);
  addLights(file, path, scene);
  checkScene(scene);
  placeCameras(file, path, scene);
  placeEnvironment(file, settings.environment, scene);
  scene.transparent_background =
      settings.transparent_background.value_or(scene.render.transparent_background.value_or(false));
  return scene;
}

}  // namespace

Scene loadScene(const fs::path& path, const LoadSettings& settings) {
  try {
    return loadWithin(path, settings);
  } catch (const std::bad_alloc&) {
    fail(path, "the scene needs more memory than there is; make it smaller");
  }
}

}  // namespace glimt
