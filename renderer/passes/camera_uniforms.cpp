#include "renderer/passes/camera_uniforms.h"

#include "renderer/scene/framing.h"

namespace glimt {

void bindCamera(gl::Program& program, const Camera& camera, int width, int height) {
  Camera upright = camera;
  upright.up = usableUp(camera);
  const CameraFrame frame(upright);
  const float half_width =
      frame.half_height * static_cast<float>(width) / static_cast<float>(height);
  program.set("uCameraPosition", camera.position);
  program.set("uCameraForward", frame.forward);
  program.set("uCameraRight", frame.right * half_width);
  program.set("uCameraUp", frame.up * frame.half_height);
}

}  // namespace glimt
