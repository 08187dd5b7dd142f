#include "renderer/passes/camera_uniforms.h"

#include "renderer/scene/framing.h"

namespace glimt {

void bindCamera(gl::Program& program, const Camera& camera, int width, int height) {
  Camera upright = camera;
  upright.up = usableUp(camera);
  const CameraFrame frame(upright);
  const bool parallel = camera.orthographic_height > 0;
  const float half_height = parallel ? camera.orthographic_height / 2 : frame.half_height;
  const float half_width = half_height * static_cast<float>(width) / static_cast<float>(height);
  program.set("uCameraPosition", camera.position);
  program.set("uCameraForward", frame.forward);
  program.set("uCameraRight", frame.right * half_width);
  program.set("uCameraUp", frame.up * half_height);
  program.set("uLensRight", frame.right * camera.aperture_radius);
  program.set("uLensUp", frame.up * camera.aperture_radius);
  program.set("uLensBlades", static_cast<float>(camera.aperture_blades));
  program.set("uFocusDistance", camera.focus_distance);
}

}  // namespace glimt
