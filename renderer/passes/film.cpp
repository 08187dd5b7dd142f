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

bool canDrawLiveOnly(const gl::Device& device) {
  return device.floatBlending() && device.stencilForm().has_value();
}

TargetPair::TargetPair(const gl::Device& device, int width, int height, bool both,
                       std::size_t textures) {
  for (std::size_t i = 0; i < (both ? 2 : 1); ++i) {
    std::vector<gl::Texture> parts;
    while (parts.size() < textures)
      parts.push_back(gl::Texture::floats(device.gl(), device.floatForm(), width, height));
    targets_[i] = gl::Target(std::move(parts));
  }
  clear();
}

void TargetPair::attach(const gl::Stencil& stencil) const {
  for (const gl::Target& target : targets_)
    if (target.width() > 0) stencil.attachTo(target);
}

Film::Film(const gl::Device& device, int width, int height, std::size_t record_textures) {
  checkSize(device, width, height);
  record = TargetPair(device, width, height, true, record_textures);
  radiance = TargetPair(device, width, height, !device.floatBlending());
  if (!canDrawLiveOnly(device)) return;
  stencil = gl::Stencil(device.gl(), *device.stencilForm(), width, height);
  record.attach(stencil);
  radiance.attach(stencil);
}

}  // namespace glimt
