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

// Reads `*.scene.json` or `*.obj`. The scene that comes back is checked: indices are in range,
// vertices finite, triangles have an area, normals unit length, a camera is set, and there is
// light. What was dropped or assumed is told in Scene::warnings.
// Errors: input, "FILE:LINE: what is wrong; what to do".
Scene loadScene(const std::filesystem::path& path, const EnvironmentChoice& environment = {});

}  // namespace glimt
