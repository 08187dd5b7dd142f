// Evaluates shader text on the device, over as many inputs as are given.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "renderer/gl/device.h"
#include "renderer/gl/program.h"

namespace glimt {

class Probe {
 public:
  using Binder = std::function<void(gl::Program&)>;

  // `text` defines `vec4 probe(vec4 a, vec4 b, ...)`, called with one value of each of `inputs`
  // lists. The prelude, layout.h and the named files of shaders/ come before it.
  Probe(const gl::Device& device, const std::vector<std::string>& files, const std::string& text,
        int inputs = 1);

  // A whole fragment shader, in the language of the given OpenGL ES version. It finds its inputs in
  // the samplers uInput0 and so on, at the pixel's centre times uProbeStep.
  Probe(const gl::Device& device, const std::string& shader, int gles = 2);

  // One result for each element of the lists, which are equally long and not empty. `bind` sets
  // uniforms of the program. The target has rows of `width` pixels. Errors: failed, for lists that
  // are not like that, and where GL answers with an error.
  std::vector<Vec4> run(const std::vector<std::vector<Vec4>>& lists, const Binder& bind = {},
                        int width = 4096);

 private:
  const gl::Device* device_;
  gl::Program program_;
};

// What Probe adds to the text: samplers and main.
std::string probeMain(int inputs);

}  // namespace glimt
