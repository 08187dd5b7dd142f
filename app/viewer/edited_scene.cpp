#include "app/viewer/edited_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <system_error>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/wording.h"
#include "renderer/scene/environment_picture.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

// Scene files are small.
constexpr std::uintmax_t kLargest = std::uintmax_t{1} << 28;

bool isSceneFile(const fs::path& path) {
  return path.extension() == ".json";
}

Json openFile(const fs::path& path) {
  if (!isSceneFile(path)) return {{"model", path.filename().string()}};
  try {
    return Json::parse(readFile(path, kLargest));
  } catch (const Json::exception&) {
    throw Error(ErrorKind::input, fmt::format("{}: is no longer what was opened; reload it",
                                              printable(path.string())));
  }
}

// To the file's coordinates.
Json placeOf(const Vec3& place, const Scene& scene) {
  if (scene.origin == glm::dvec3(0)) return jsonOf(place);
  const glm::dvec3 there = scene.origin + glm::dvec3(place);
  return Json::array({there.x, there.y, there.z});
}

Json cameraJson(const Camera& camera, const Scene& scene) {
  Json json{{"position", placeOf(camera.position, scene)},
            {"target", placeOf(camera.target, scene)},
            {"up", jsonOf(camera.up)}};
  if (camera.orthographic_height > 0)
    json["orthographic_height"] = jsonOf(camera.orthographic_height);
  else
    json["vertical_fov"] = jsonOf(camera.vertical_fov);
  if (camera.aperture_radius > 0) {
    json["aperture_radius"] = jsonOf(camera.aperture_radius);
    json["focus_distance"] = jsonOf(camera.focus_distance);
    if (camera.aperture_blades > 0) json["aperture_blades"] = camera.aperture_blades;
  }
  return json;
}

// The picture's name as a scene file beside the one that is open has it.
std::string imageNameOf(const std::string& chosen) {
  if (chosen == kStudioName || chosen == kSunSkyName) return chosen;
  std::error_code ignored;
  return fs::absolute(chosen, ignored).string();
}

// `before` is what the open file says of it.
Json environmentOf(const LoadedScene& loaded, const Look& look, const Json& before) {
  Json json = before;
  const auto& chosen = loaded.choice.settings.environment.image;
  const Environment& environment = loaded.scene.environment;
  const bool picture = !environment.image.pixels.empty();
  if (chosen)
    json = {{"image", imageNameOf(*chosen)}};
  else if (json.empty() && picture)
    json["image"] = kStudioName;
  if (json.empty() && environment.color == Vec3(0)) return json;
  if (!json.contains("color") && environment.color != Vec3(1))
    json["color"] = jsonOf(environment.color);
  json["strength"] = jsonOf(look.environment_strength);
  if (picture) json["rotation"] = jsonOf(look.environment_rotation);
  return json;
}

// Adds what differs.
void addChanges(const Material& before, const Material& now, Json& json) {
  const auto add = [&json](const char* key, const auto& was, const auto& is) {
    if (was != is) json[key] = jsonOf(is);
  };
  add("base_color", before.base_color, now.base_color);
  add("emission", before.emission, now.emission);
  add("metallic", before.metallic, now.metallic);
  add("roughness", before.roughness, now.roughness);
  add("ior", before.ior, now.ior);
  add("transmission", before.transmission, now.transmission);
  add("clearcoat", before.clearcoat, now.clearcoat);
  add("clearcoat_roughness", before.clearcoat_roughness, now.clearcoat_roughness);
  add("sheen_color", before.sheen_color, now.sheen_color);
  add("sheen_roughness", before.sheen_roughness, now.sheen_roughness);
  // Who speaks of gloss in a scene file changes this number, too, unless he speaks of it.
  bool gloss = before.specular != now.specular;
  for (const char* key : {"metallic", "roughness", "ior", "transmission"})
    gloss = gloss || json.contains(key);
  if (gloss) json["specular"] = jsonOf(now.specular);
}

void addMaterials(const LoadedScene& loaded, const Look& look, EditedScene& edited) {
  std::map<std::string, std::size_t> first_of_name;
  for (std::size_t i = 0; i < loaded.scene.materials.size(); ++i)
    first_of_name.try_emplace(loaded.scene.materials[i].name, i);
  for (std::size_t i = 0; i < look.materials.size(); ++i) {
    const Material& before = loaded.scene.materials[i];
    const Material& now = look.materials[i];
    if (now == before) continue;
    if (before.name.empty() || first_of_name.at(before.name) != i) {
      edited.warnings.push_back(
          fmt::format("material {} has no name of its own, so its changes are not saved", i + 1));
      continue;
    }
    Json& json = edited.file["materials"][before.name];
    if (json.is_null()) json = Json::object();
    addChanges(before, now, json);
  }
}

bool near(float a, float b) {
  return std::abs(a - b) <= 1e-5f * std::abs(b);
}

}  // namespace

EditedScene editedScene(const LoadedScene& loaded, const Look& look, const Camera& camera,
                        std::array<int, 2> size) {
  EditedScene edited{openFile(loaded.choice.path), {}};
  Json& file = edited.file;
  if (!look.variant.empty()) file["variant"] = look.variant;
  file["camera"] = cameraJson(camera, loaded.scene);
  const Json environment = environmentOf(loaded, look, file.value("environment", Json::object()));
  if (!environment.empty()) file["environment"] = environment;
  addMaterials(loaded, look, edited);
  Json& render = file["render"];
  render["size"] = size;
  render["bounces"] = look.bounces;
  render["exposure"] = jsonOf(look.exposure);
  render["tone"] = kToneNames[static_cast<std::size_t>(look.tone)];
  return edited;
}

bool fitsCommandLine(const LoadedScene& loaded, const Look& look, const Camera& camera) {
  const Camera& file = loaded.scene.camera;
  const bool parallel = camera.orthographic_height > 0 || file.orthographic_height > 0;
  // The command line moves the focus with the target.
  const bool lens = camera.aperture_radius > 0 &&
                    !near(camera.focus_distance, glm::distance(camera.position, camera.target));
  const bool same_lens = camera.aperture_radius == file.aperture_radius &&
                         camera.aperture_blades == file.aperture_blades;
  return look.materials == loaded.scene.materials && !parallel && !lens && same_lens;
}

fs::path editedSceneName(const fs::path& open) {
  const bool scene_file = isSceneFile(open);
  const std::string stem =
      scene_file ? open.stem().stem().string() + "-edited" : open.stem().string();
  fs::path file = open.parent_path() / (stem + ".scene.json");
  std::error_code ignored;
  for (int number = 2; fs::exists(file, ignored); ++number)
    file = open.parent_path() / fmt::format("{}-{}.scene.json", stem, number);
  return file;
}

}  // namespace glimt
