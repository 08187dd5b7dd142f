// From a file to a Scene that is safe to render.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "renderer/scene/scene.h"

namespace glimt {

// What to light a scene with instead of what its file asks for.
struct EnvironmentChoice {
  std::optional<std::string> image;  // "studio", "sun-sky" or a file
  std::optional<float> rotation;     // degrees
  std::optional<float> strength;
};

// What is chosen of a file that holds more than one scene, or instead of what it holds.
struct LoadSettings {
  std::string variant;  // of the materials, one of Scene::variants; empty: as they are without
  EnvironmentChoice environment;
  std::optional<bool> transparent_background = std::nullopt;  // none: as the file says
};

// Reads `*.scene.json`, `*.obj`, `*.gltf` or `*.glb`. The scene that comes back is checked: indices
// are in range, vertices finite, triangles have an area, normals unit length, a camera is set, and
// there is light. What was dropped or assumed is told in Scene::warnings. Errors: input,
// "FILE:LINE: what is wrong; what to do"; usage, for a variant that is not there.
Scene loadScene(const std::filesystem::path& path, const LoadSettings& settings = {});

}  // namespace glimt
