#include "renderer/doctor.h"

#include <algorithm>
#include <array>
#include <functional>

#include "renderer/core/error.h"
#include "renderer/doctor/examination.h"

namespace glimt {
namespace {

template <class Subject>
struct Examination {
  const char* name;
  Outcome (*run)(const Subject& subject);
};

constexpr std::array kOfContext{
    Examination<gl::Context>{"context", examineContext},
    Examination<gl::Context>{"float targets", examineFloatTargets},
    Examination<gl::Context>{"highp floats", examinePrecisionClaim},
    Examination<gl::Context>{"texture size", examineTextureSize},
    Examination<gl::Context>{"texture units", examineTextureUnits},
    Examination<gl::Context>{"timer queries", examineTimers},
};

constexpr std::array kOfDevice{
    Examination<gl::Device>{"guards against 16 bits", examineGuards},
    Examination<gl::Device>{"whole numbers", examineIntegers},
    Examination<gl::Device>{"numbers of all sizes", examineScaledIntegers},
    Examination<gl::Device>{"float blending", examineBlending},
    Examination<gl::Device>{"values not finite", examineNonfinite},
    Examination<gl::Device>{"denormals", examineDenormals},
    Examination<gl::Device>{"hit record", examineRecords},
    Examination<gl::Device>{"stochastic rounding", examineRounding},
    Examination<gl::Device>{"loop limit", examineLoops},
    Examination<gl::Device>{"texel addresses", examineAddresses},
};

template <class Subject>
Finding examineOne(const Examination<Subject>& examination, const Subject& subject) {
  try {
    const Outcome outcome = examination.run(subject);
    return {examination.name, outcome.result, outcome.verdict, outcome.consequence};
  } catch (const Error& error) {
    return {examination.name, error.what(), Verdict::fatal, "this cannot be tried here"};
  }
}

}  // namespace

std::vector<Finding> examine(ContextHandle& context) {
  std::vector<Finding> findings;
  for (const auto& examination : kOfContext)
    findings.push_back(examineOne(examination, context.get()));
  try {
    const gl::Device device(context.get());
    for (const auto& examination : kOfDevice) findings.push_back(examineOne(examination, device));
  } catch (const Error&) {  // without float targets, which is among the findings, there is no more
  }
  return findings;
}

bool isUsable(const std::vector<Finding>& findings) {
  return std::none_of(findings.begin(), findings.end(),
                      [](const Finding& finding) { return finding.verdict == Verdict::fatal; });
}

std::string nameOf(Verdict verdict) {
  constexpr std::array kNames{"ok", "warning", "fatal"};
  return kNames[static_cast<std::size_t>(verdict)];
}

}  // namespace glimt
