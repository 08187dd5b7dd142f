// Where the camera stands when the file does not say, or not all of it.
#pragma once

#include <optional>

#include "renderer/core/bounds.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/scene.h"

namespace glimt {

// What a file says about its camera.
struct CameraSettings {
  std::optional<glm::dvec3> position;
  std::optional<glm::dvec3> target;
  std::optional<Vec3> up;
  std::optional<float> vertical_fov;
  std::optional<float> orthographic_height;
  std::optional<float> aperture_radius;
  std::optional<float> focus_distance;  // nothing: that of the target
  std::optional<int> aperture_blades;
};

Bounds boundsOf(const Scene& scene);

// The model from the front: from the +z side along -z, its box centred and filling a picture of
// that aspect (width / height); a model that lies flat from the front and 45 degrees above. What
// `settings` says is kept: with a position alone the camera looks at the model's centre, with a
// target alone it looks there from the front.
Camera framed(const Bounds& bounds, float aspect, const CameraSettings& settings = {});

// `up`, or where it is parallel to the view, another direction that is not: looking down, the top
// of the picture is -z; looking up, it is +z.
Vec3 usableUp(const Camera& camera);

}  // namespace glimt
