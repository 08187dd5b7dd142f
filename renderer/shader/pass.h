// The passes that make a picture.
#pragma once

#include <array>
#include <string>

namespace glimt {

enum class Pass {
  camera,       // camera ray -> hit record
  trace,        // hit record -> next hit record
  escape,       // hit record that has left the scene -> radiance
  light,        // hit record on a surface -> radiance
  accumulate,   // radiance -> sum of a block of samples
  close_block,  // sum of a block -> mean
  first_hit,    // hit record of the camera's ray -> what it has met
  delta,        // hit record on a mirror or smooth glass -> what it shows
  guide,        // hit record -> what the denoiser knows of it
  guide_sum,    // that -> the sum over paths
  keep,         // mean -> its luminance, kept
  change,       // mean and what was kept -> by how much it has changed
  prepare,      // mean -> light without the colour of what is seen, and its variance
  neighbours,   // that without the variance -> that with it
  atrous,       // that -> the same with less noise
  finish,       // that -> denoised mean
  display,      // mean -> display values
};
inline constexpr std::size_t kPassCount = 17;

// For messages.
inline std::string nameOf(Pass pass) {
  constexpr std::array kNames{"camera",      "trace",     "escape",  "light",      "accumulate",
                              "close block", "first hit", "delta",   "guide",      "guide sum",
                              "keep",        "change",    "prepare", "neighbours", "atrous",
                              "finish",      "display"};
  static_assert(kNames.size() == kPassCount);
  return kNames[static_cast<std::size_t>(pass)];
}

}  // namespace glimt
