#include "renderer/passes/camera_uniforms.h"

namespace glimt {

void bindCamera(gl::Program& program, const Camera& camera, int width, int height) {
  const CameraFrame frame(camera);
  const float half_width =
      frame.half_height * static_cast<float>(width) / static_cast<float>(height);
  program.set("uCameraPosition", camera.position);
  program.set("uCameraForward", frame.forward);
  program.set("uCameraRight", frame.right * half_width);
  program.set("uCameraUp", frame.up * frame.half_height);
}

}  // namespace glimt
