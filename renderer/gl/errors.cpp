#include "renderer/gl/errors.h"

#include <fmt/format.h>

#include <string>

namespace glimt::gl {
namespace {

// Of ES 3.2 and of GL_KHR_robustness, GL_EXT_robustness and GL_ARB_robustness alike.
constexpr GLenum kContextLost = 0x0507;
constexpr GLenum kGuiltyReset = 0x8253;
constexpr GLenum kInnocentReset = 0x8254;

// One error of each kind can wait. A context that is lost, or not current, may never run out.
constexpr int kMostErrors = 16;

std::string nameOf(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "invalid enum";
    case GL_INVALID_VALUE:
      return "invalid value";
    case GL_INVALID_OPERATION:
      return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "invalid framebuffer operation";
    default:
      return "unknown";
  }
}

const char* causeOf(GLenum reset) {
  if (reset == kGuiltyReset) return "the driver was reset because of this program's draws";
  if (reset == kInnocentReset) return "the driver was reset because of another program";
  return "the driver was reset, or the device is gone";
}

std::string describe(GLenum reset, GLenum error, std::string_view doing) {
  if (reset != GL_NO_ERROR || error == kContextLost)
    return fmt::format("the GL context was lost while {}: {}; try again, or with --backend osmesa",
                       doing, causeOf(reset));
  if (error == GL_OUT_OF_MEMORY)
    return fmt::format(
        "GL is out of memory while {}; use a smaller --size or a smaller model, or end other "
        "programs that draw",
        doing);
  return fmt::format("GL error 0x{:04x} ({}) while {}; run glimt doctor, and try another --backend",
                     error, nameOf(error), doing);
}

}  // namespace

void clearErrors(const Functions& gl) {
  for (int i = 0; i < kMostErrors && gl.GetError() != GL_NO_ERROR; ++i) {
  }
}

void checkErrors(const Functions& gl, std::string_view doing, ErrorKind kind) {
  const GLenum reset = gl.GetGraphicsResetStatus ? gl.GetGraphicsResetStatus() : GL_NO_ERROR;
  const GLenum error = gl.GetError();
  if (reset == GL_NO_ERROR && error == GL_NO_ERROR) return;
  throw Error(kind, describe(reset, error, doing));
}

}  // namespace glimt::gl
