#include <fmt/format.h>

#include <algorithm>

#include "renderer/core/wording.h"
#include "renderer/doctor/examination.h"
#include "renderer/passes/data_texture.h"
#include "renderer/probes/address_probe.h"
#include "renderer/probes/loop_turns.h"
#include "renderer/probes/record_probes.h"
#include "shaders/layout.h"

namespace glimt {

Outcome examineRecords(const gl::Device& device) {
  const RecordProbe probe = probeRecords(device);
  return verdictOf(probe.wrong == 0,
                   fmt::format("{} of {} wrong", grouped(probe.wrong), grouped(probe.records)),
                   "what one bounce leaves for the next arrives", Verdict::fatal,
                   "paths go on from other places, in other directions or with other colours");
}

Outcome examineRounding(const gl::Device& device) {
  constexpr double kMostErrors = 5;
  const double errors = probeRounding(device);
  return verdictOf(
      errors <= kMostErrors, fmt::format("means are within {:.1f} standard errors", errors),
      "rounding does not move the mean of the picture", Verdict::fatal,
      fmt::format("more than {}: pictures come out too bright or too dark", kMostErrors));
}

Outcome examineLoops(const gl::Device& device) {
  constexpr std::uint32_t kSteps = MAX_STEPS;
  const auto limit = findLoopLimit(device);
  const std::string linear =
      fmt::format("traversal 'linear' takes up to {}",
                  counted(std::min(limit.value_or(kSteps), kSteps), "triangle"));
  if (!limit) return {fmt::format("none up to {}", grouped(kMostLoopTurns)), Verdict::ok, linear};
  // Trees of sound scenes ask for hundreds of turns.
  constexpr std::uint32_t kPlenty = 60000;
  return {fmt::format("loops end after {} turns, without a word", grouped(*limit)),
          *limit < kPlenty ? Verdict::warning : Verdict::ok,
          linear + "; a ray that needs more turns is left out of the mean and counted"};
}

// Devices tend to lose the low bits of addresses that are large: the largest size that works
// counts.
Outcome examineAddresses(const gl::Device& device) {
  constexpr std::size_t kLeastUseful = std::size_t{1} << 18;
  const std::size_t largest = mostTexels(device.maxTextureSize());
  std::size_t size = largest;
  AddressProbe probe = probeAddresses(device, size);
  const std::string result = fmt::format("{} of {} wrong, in a texture of {}", grouped(probe.wrong),
                                         grouped(probe.elements), counted(largest, "texel"));
  if (probe.wrong == 0)
    return {result, Verdict::ok, "every element of the largest textures is found"};
  while (probe.wrong > 0 && size > kLeastUseful) {
    size /= 2;
    probe = probeAddresses(device, size);
  }
  const std::size_t triangles = size / static_cast<std::size_t>(TRIANGLE_TEXELS);
  if (probe.wrong == 0)
    return {fmt::format("{}; none in one of {}", result, grouped(size)), Verdict::warning,
            fmt::format("scenes whose data is larger come out wrong: more than {} in any case",
                        counted(triangles, "triangle"))};
  return {result, Verdict::fatal, "rays read other triangles and nodes than they ask for"};
}

}  // namespace glimt
