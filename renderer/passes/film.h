// The targets that a sample of a picture is made in.
#pragma once

#include <array>

#include "renderer/gl/device.h"

namespace glimt {

// Two targets, one to read and one to write, which change places. Or only the one to read.
class TargetPair {
 public:
  TargetPair() = default;
  TargetPair(const gl::Device& device, int width, int height, bool both = true,
             std::size_t textures = 1);  // of each target

  const gl::Target& front() const { return targets_[front_]; }     // to read
  const gl::Target& back() const { return targets_[1 - front_]; }  // to write
  void swap() { front_ = 1 - front_; }
  void clear() const { front().clear(); }
  void attach(const gl::Stencil& stencil) const;

 private:
  std::array<gl::Target, 2> targets_;
  std::size_t front_ = 0;
};

// Whether draws can be limited to pixels with a live path. Not where radiance is added by reading,
// since every pixel has to be written then.
bool canDrawLiveOnly(const gl::Device& device);

struct Film {
  Film() = default;
  // Errors: usage, when the picture is larger than the device's textures.
  Film(const gl::Device& device, int width, int height, std::size_t record_textures = 1);

  int width() const { return record.front().width(); }
  int height() const { return record.front().height(); }

  TargetPair record;    // hit records of this bounce and of the next
  TargetPair radiance;  // of this sample; two only where the device cannot blend floats
  gl::Stencil stencil;  // of record and radiance, where draws are limited to live paths
};

}  // namespace glimt
