// The kinds of work that the device is measured with: shaders that do one thing over and over.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace glimt {

struct DeviceWork {
  std::string name;
  std::string unit;           // what its rate counts, in thousand millions a second
  double amount_per_turn;     // of that, in one turn of the loop
  std::string traversal;      // one whose files come before the text; empty for none
  std::string text;           // a fragment shader's main with TURNS turns
  std::size_t texture_bytes;  // of uTexels; 0 where it fetches nothing
};

inline constexpr const char* kArithmeticWork = "multiply-add";
inline constexpr const char* kBoxWork = "ray against box";
inline constexpr const char* kOrderedBoxWork = "ray against box, corners in order";
inline constexpr const char* kTriangleWork = "ray against triangle";

// From registers.
std::vector<DeviceWork> arithmeticWorks();

// What the nearest cache of any device holds.
inline constexpr std::size_t kSmallTexture = 16 * 1024;  // bytes

// Texels that do not depend on each other.
DeviceWork sameTexelWork();
DeviceWork neighboursWork();
DeviceWork randomTexelsWork(std::size_t bytes);

// Each texel says where the next one is.
DeviceWork chainWork(std::size_t bytes);

}  // namespace glimt
