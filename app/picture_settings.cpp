#include "app/picture_settings.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "renderer/core/error.h"
#include "renderer/core/wording.h"
#include "renderer/scene/default_bounces.h"
#include "renderer/scene/effects_of.h"
#include "renderer/scene/framing.h"

namespace glimt {
namespace {

Camera cameraNamed(const std::string& name, const Scene& scene) {
  std::vector<std::string> names;
  for (const NamedCamera& named : scene.cameras) {
    if (named.name == name) return named.camera;
    names.push_back(named.name);
  }
  throw Error(ErrorKind::usage,
              fmt::format("the scene has no camera named '{}'; {}", printable(name),
                          names.empty() ? "use --eye, --target, --up and --fov"
                                        : "it has " + listed(names)));
}

}  // namespace

Camera cameraOf(const CameraOptions& options, const Scene& scene) {
  if (!options.name.empty()) return cameraNamed(options.name, scene);
  Camera camera = scene.camera;
  // Where the lens is sharp at the target it stays so.
  const float before = glm::distance(camera.position, camera.target);
  const bool at_target = std::abs(camera.focus_distance - before) <= 1e-5f * before;
  if (options.eye) camera.position = Vec3(*options.eye - scene.origin);
  if (options.target) camera.target = Vec3(*options.target - scene.origin);
  camera.up = options.up ? *options.up : usableUp(camera);
  camera.vertical_fov = options.vertical_fov.value_or(camera.vertical_fov);

  const Vec3 forward = camera.target - camera.position;
  if (at_target) camera.focus_distance = glm::length(forward);
  if (!(glm::length(forward) > 0)) {
    throw Error(ErrorKind::usage, "the camera is at its target; move --eye or --target");
  }
  const Vec3 side = glm::cross(forward, camera.up);
  if (!(glm::length(side) > 1e-6f * glm::length(forward) * glm::length(camera.up))) {
    throw Error(ErrorKind::usage, "the camera's up is along its view; give another --up");
  }
  return camera;
}

RenderSettings settingsOf(const PictureOptions& options, const Scene& scene) {
  const auto [width, height] =
      options.size.value_or(scene.render.size.value_or(std::array{512, 512}));
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.bounces = options.bounces.value_or(
      scene.render.bounces.value_or(defaultBounces(effectsOf(scene)).bounces));
  settings.seed = options.seed;
  settings.traversal = options.traversal;
  settings.record = options.record;
  settings.sampler = options.sampler;
  settings.roulette = options.roulette;
  settings.clamp = options.clamp;
  return settings;
}

float exposureOf(const PictureOptions& options, const Scene& scene) {
  return options.exposure.value_or(scene.render.exposure.value_or(0.0f));
}

Tone toneOf(const PictureOptions& options, const Scene& scene) {
  return options.tone.value_or(scene.render.tone.value_or(Tone::srgb));
}

}  // namespace glimt
