// The camera as shaders/camera.glsl reads it.
#pragma once

#include "renderer/gl/program.h"
#include "renderer/scene/camera.h"

namespace glimt {

// Sets the camera's uniforms of the program in use, for a picture of that many pixels. A camera
// that looks along its up gets another one, see usableUp().
void bindCamera(gl::Program& program, const Camera& camera, int width, int height);

}  // namespace glimt
