// What a GL context is, for reports.
#pragma once

#include <string>

namespace glimt {

struct ContextInfo {
  std::string backend;    // "egl surfaceless", "egl device", "egl pbuffer", "osmesa", "window"
  std::string renderer;   // GL_RENDERER
  std::string version;    // GL_VERSION
  int gles = 2;           // the major version that was asked for
  bool software = false;  // a rasteriser on the CPU, as far as the renderer's name tells
};

}  // namespace glimt
