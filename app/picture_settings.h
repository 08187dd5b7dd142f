// What a picture is asked to be on the command line, joined with what the scene's file asks for.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "renderer/renderer.h"
#include "renderer/scene/load_scene.h"
#include "renderer/scene/scene.h"

namespace glimt {

// Single parts of the scene's camera, replaced.
struct CameraOptions {
  std::string name;
  std::optional<glm::dvec3> eye;  // in the coordinates of the scene's file, as `target`
  std::optional<glm::dvec3> target;
  std::optional<Vec3> up;
  std::optional<float> vertical_fov;  // degrees
};

struct PictureOptions {
  CameraOptions camera;
  EnvironmentChoice environment;
  std::optional<std::array<int, 2>> size;
  std::optional<int> bounces;
  std::optional<float> exposure;  // EV
  std::optional<Tone> tone;
  std::optional<bool> transparent_background;
  std::uint32_t seed = 0;
  std::string traversal = "auto";
  std::string record = "packed";
  Sampler sampler = Sampler::sobol;
  bool roulette = true;
  std::optional<float> clamp;
  int gles = 2;
};

// The scene's camera with the parts that the options replace. Errors: usage, for a name that the
// scene does not have, and for a camera without a direction.
Camera cameraOf(const CameraOptions& options, const Scene& scene);

// The command line, else the scene's file, else what is built in.
RenderSettings settingsOf(const PictureOptions& options, const Scene& scene);
float exposureOf(const PictureOptions& options, const Scene& scene);
Tone toneOf(const PictureOptions& options, const Scene& scene);

}  // namespace glimt
