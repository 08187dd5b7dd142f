// The camera as shaders/camera.glsl reads it.
#pragma once

#include "renderer/gl/program.h"
#include "renderer/scene/camera.h"

namespace glimt {

// Sets the camera's uniforms of the program in use, for a picture of that many pixels.
void bindCamera(gl::Program& program, const Camera& camera, int width, int height);

}  // namespace glimt
