// One row of what the doctor looks at.
#pragma once

#include "renderer/doctor.h"
#include "renderer/gl/device.h"

namespace glimt {

struct Outcome {
  std::string result;
  Verdict verdict = Verdict::ok;
  std::string consequence;
};

// `ok`, or what it means that it is not.
inline Outcome verdictOf(bool ok, const std::string& result, const std::string& consequence,
                         Verdict otherwise, const std::string& other_consequence) {
  return {result, ok ? Verdict::ok : otherwise, ok ? consequence : other_consequence};
}

// Of the context as it comes.
Outcome examineContext(const gl::Context& context);
Outcome examineFloatTargets(const gl::Context& context);
Outcome examinePrecisionClaim(const gl::Context& context);
Outcome examineTextureSize(const gl::Context& context);
Outcome examineTextureUnits(const gl::Context& context);
Outcome examineTimers(const gl::Context& context);

// Of numbers in targets, textures and shaders.
Outcome examineGuards(const gl::Device& device);
Outcome examineIntegers(const gl::Device& device);
Outcome examineScaledIntegers(const gl::Device& device);
Outcome examineBlending(const gl::Device& device);
Outcome examineNonfinite(const gl::Device& device);
Outcome examineDenormals(const gl::Device& device);

// Of what paths need.
Outcome examineRecords(const gl::Device& device);
Outcome examineRounding(const gl::Device& device);
Outcome examineLoops(const gl::Device& device);
Outcome examineAddresses(const gl::Device& device);

}  // namespace glimt
