// The *.scene.json: a model, and what its format cannot say.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/scene/framing.h"
#include "renderer/scene/light_settings.h"
#include "renderer/scene/scene.h"

namespace glimt {

// What the file says about one material; it wins over the model's own.
struct MaterialSettings {
  std::string name;
  std::optional<Vec3> base_color;
  std::optional<Vec3> emission;
  std::optional<bool> double_sided;
  std::optional<float> metallic;
  std::optional<float> roughness;
  std::optional<float> ior;
  std::optional<float> specular;
  std::optional<float> transmission;
  std::optional<bool> thin_walled;
  std::optional<Vec3> attenuation_color;
  std::optional<float> attenuation_distance;
  std::optional<float> clearcoat;
  std::optional<float> clearcoat_roughness;
  std::optional<Vec3> sheen_color;
  std::optional<float> sheen_roughness;
  std::optional<bool> shadow_catcher;
};

struct NamedCameraSettings {
  std::string name;
  CameraSettings camera;
};

struct SceneFile {
  std::filesystem::path model;
  std::string variant;  // of the model's materials; empty: as they are without
  CameraSettings camera;
  std::vector<NamedCameraSettings> cameras;
  std::optional<Environment> environment;  // nothing: the file does not speak of it
  std::vector<LightSettings> lights;
  std::vector<MaterialSettings> materials;
  RenderDefaults render;
  std::vector<std::string> warnings;
};

// Errors: input, naming the key; also from reading the environment's picture.
SceneFile readSceneFile(const std::filesystem::path& path);

// Gives the model's materials what the file says about them.
void applyMaterials(const SceneFile& file, Scene& scene);

}  // namespace glimt
