// Some drivers end the loops of a shader after a number of turns, without a word.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/probes/probe.h"

namespace glimt {

inline constexpr std::uint32_t kMostLoopTurns = 1u << 22;  // that can be asked for

class LoopProbe {
 public:
  explicit LoopProbe(const gl::Device& device);

  // How many turns all loops of one invocation make together when they are to make `wanted`: fewer
  // where the driver ends them early. Takes about as long as so many turns take one pixel.
  std::uint32_t turns(std::uint32_t wanted);

 private:
  Probe probe_;
};

// The number of turns after which the driver ends loops; none where it makes all of `most`.
std::optional<std::uint32_t> findLoopLimit(const gl::Device& device,
                                           std::uint32_t most = kMostLoopTurns);

}  // namespace glimt
