#include "renderer/scene/light_settings.h"

#include <fmt/format.h>

#include <limits>

namespace glimt {
namespace {

constexpr double kLargestFloat = std::numeric_limits<float>::max();
constexpr Range kPlace = {-1e15, 1e15, "a number of metres between -1e15 and 1e15"};
constexpr Range kPositive = {0, kLargestFloat, "a number that is not negative"};
constexpr Range kFinite = {-1e8, 1e8, "a number between -1e8 and 1e8"};
constexpr Range kCone = {0, 90, "a number of degrees between 0 and 90"};

PunctualLight::Kind readKind(const JsonFields& fields) {
  const std::string type = fields.text("type").value_or("point");
  if (type == "point") return PunctualLight::Kind::point;
  if (type == "spot") return PunctualLight::Kind::spot;
  if (type != "directional") fields.reject("type", "point, spot or directional");
  return PunctualLight::Kind::directional;
}

// Keys that would do nothing are errors: whoever writes them expects something of them.
void rejectUnused(const JsonFields& fields, PunctualLight::Kind kind) {
  if (kind != PunctualLight::Kind::spot)
    for (const char* key : {"inner_cone", "outer_cone"})
      if (fields.has(key)) fields.reject(key, "left out; only a spot has cones");
  if (kind == PunctualLight::Kind::point && fields.has("direction"))
    fields.reject("direction", "left out; a point shines in all directions");
  if (kind == PunctualLight::Kind::directional)
    for (const char* key : {"position", "range"})
      if (fields.has(key)) fields.reject(key, "left out; a directional light is nowhere");
}

LightSettings readLight(const JsonFields& fields) {
  LightSettings settings;
  PunctualLight& light = settings.light;
  light.kind = readKind(fields);
  rejectUnused(fields, light.kind);
  light.name = fields.text("name").value_or("");
  settings.position = fields.point("position", kPlace).value_or(glm::dvec3(0));
  light.direction = fields.vector("direction", kFinite).value_or(Vec3(0, -1, 0));
  if (light.direction == Vec3(0)) fields.reject("direction", "a direction");
  light.direction = Vec3(glm::normalize(glm::dvec3(light.direction)));
  light.intensity = fields.vector("intensity", kPositive).value_or(Vec3(1));
  light.range = fields.number("range", kPositive).value_or(0.0f);
  const float outer = fields.number("outer_cone", kCone).value_or(45.0f);
  const float inner = fields.number("inner_cone", kCone).value_or(0.0f);
  if (inner > outer) fields.reject("inner_cone", "no larger than outer_cone");
  light.inner_cone = glm::radians(inner);
  light.outer_cone = glm::radians(outer);
  return settings;
}

}  // namespace

std::vector<LightSettings> readLights(const JsonDocument& document, const nlohmann::json& lights) {
  std::vector<LightSettings> read;
  for (std::size_t i = 0; i < lights.size(); ++i)
    read.push_back(readLight(JsonFields(document, fmt::format("lights[{}]", i), lights[i],
                                        {"type", "name", "position", "direction", "intensity",
                                         "range", "inner_cone", "outer_cone"})));
  return read;
}

}  // namespace glimt
