// The pure files of shaders/ in single precision, as the device computes. Made by CMakeLists.txt.
#pragma once

#include <glm/glm.hpp>

namespace glimt::glsl_float {

#include "tests/shader/all_effects.inc"
#include "tests/shader/glsl_names.inc"

using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;

// The shaders' functions are not inline, so every file that includes this gets its own.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
namespace {
#include "glsl_float.inc"
}  // namespace
#pragma GCC diagnostic pop

}  // namespace glimt::glsl_float
