// How light becomes what a display shows.
#pragma once

#include <array>
#include <string_view>

namespace glimt {

enum class Tone {
  srgb,  // as it is, clipped at 1: for comparisons
  agx,   // AgX: bright colours fade to white and keep their hue
  aces,  // ACES: contrast as of film
};

// As the command line and scene files call them, in the order of the enumeration.
inline constexpr std::array<const char*, 3> kToneNames{"srgb", "agx", "aces"};

// `name` is one of them.
inline Tone toneNamed(std::string_view name) {
  for (std::size_t i = 0; i < kToneNames.size(); ++i)
    if (name == kToneNames[i]) return static_cast<Tone>(i);
  return Tone::srgb;
}

}  // namespace glimt
