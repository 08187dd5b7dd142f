#include <fmt/format.h>

#include "renderer/core/wording.h"
#include "renderer/doctor/examination.h"
#include "renderer/probes/arithmetic_probes.h"
#include "renderer/probes/guard_probes.h"
#include "renderer/probes/number_probes.h"

namespace glimt {
namespace {

std::string describe(const NumbersProbe& probe) {
  return fmt::format("{} of {} texels wrong", grouped(probe.wrong), grouped(probe.texels));
}

}  // namespace

// A guard is needed where numbers come out wrong without it.
Outcome examineGuards(const gl::Device& device) {
  std::vector<std::string> needed;
  std::vector<std::string> broken;
  for (const GuardProbe& probe : probeGuards(device)) {
    const bool known = !needed.empty() && needed.back() == probe.guard;
    if (probe.wrong_without > 0 && !known) needed.push_back(probe.guard);
    if (probe.wrong > 0) broken.push_back(probe.guard);
  }
  if (!broken.empty())
    return {fmt::format("wrong in spite of {}", fmt::join(broken, ", ")), Verdict::fatal,
            "shaders compute in 16 bits whatever they ask for"};
  if (needed.empty())
    return {"not needed", Verdict::ok, "shaders compute in 32 bits by themselves"};
  return {fmt::format("wrong without {}", fmt::join(needed, ", ")), Verdict::ok,
          "the driver computes in 16 bits where it may; with the guards it does not"};
}

Outcome examineIntegers(const gl::Device& device) {
  const NumbersProbe probe = probeAllIntegers(device);
  return verdictOf(probe.wrong == 0, describe(probe),
                   "all of 24 bits are stored and fetched exactly", Verdict::fatal,
                   "hit records and indices of triangles are lost");
}

Outcome examineScaledIntegers(const gl::Device& device) {
  const NumbersProbe probe = probeScaledIntegers(device);
  return verdictOf(probe.wrong == 0, describe(probe),
                   "24 bits times 2^-60 to 2^60 are stored and fetched exactly", Verdict::fatal,
                   "hit records and the scene's coordinates are lost");
}

Outcome examineBlending(const gl::Device& device) {
  if (!device.floatBlending())
    return {"not there", Verdict::ok, "light is added by reading the sum so far: a bit slower"};
  const bool exact = addsExactly(device);
  return verdictOf(exact, exact ? "adds exactly" : "claimed, but adds something else",
                   "light is added by blending", Verdict::fatal,
                   "light is lost where the driver's word is taken");
}

Outcome examineNonfinite(const gl::Device& device) {
  const bool detected = detectsNonfinite(device);
  return verdictOf(detected, detected ? "told by comparisons" : "not told by comparisons",
                   "such samples are left out of the mean and counted", Verdict::warning,
                   "a sample that is not finite spoils its pixel for good");
}

Outcome examineDenormals(const gl::Device& device) {
  return {keepsDenormals(device) ? "kept" : "flushed to zero", Verdict::ok,
          "none: hit records hold no number that small"};
}

}  // namespace glimt
