// The lights without triangles of a scene file.
#pragma once

#include <vector>

#include "renderer/scene/json_fields.h"
#include "renderer/scene/scene.h"

namespace glimt {

// One of them, its position as the file gives it, in the coordinates of the model's file.
struct LightSettings {
  PunctualLight light;
  glm::dvec3 position{0};
};

// The file's "lights": an array of objects. Errors: input, naming the key.
std::vector<LightSettings> readLights(const JsonDocument& document, const nlohmann::json& lights);

}  // namespace glimt
