#include "renderer/passes/film.h"

#include <fmt/format.h>

#include "renderer/core/error.h"

namespace glimt {
namespace {

void checkSize(const gl::Device& device, int width, int height) {
  const int largest = device.maxTextureSize();
  if (width > largest || height > largest)
    throw Error(
        ErrorKind::usage,
        fmt::format("a picture of {} x {} is larger than this device can draw ({} x {}); ask "
                    "for a smaller --size",
                    width, height, largest, largest));
}

}  // namespace

TargetPair::TargetPair(const gl::Device& device, int width, int height) {
  for (gl::Target& target : targets_) {
    target = gl::Target(gl::Texture::floats(device.gl(), device.floatForm(), width, height));
    target.clear();
  }
}

void TargetPair::clear() {
  for (gl::Target& target : targets_) target.clear();
}

Film::Film(const gl::Device& device, int width, int height) {
  checkSize(device, width, height);
  record = TargetPair(device, width, height);
  radiance = TargetPair(device, width, height);
  mean = TargetPair(device, width, height);
}

}  // namespace glimt
