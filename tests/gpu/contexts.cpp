#include "tests/gpu/contexts.h"

#include <array>
#include <catch2/catch.hpp>

#include "renderer/core/error.h"
#include "tests/shader/report.h"

namespace glimt::test {
namespace {

struct Maker {
  const char* name;
  std::unique_ptr<gl::Context> (*make)(int gles);
  int gles;
};

constexpr std::array kMakers{
    Maker{"egl surfaceless, ES 2", gl::createEglSurfacelessContext, 2},
    Maker{"egl surfaceless, ES 3", gl::createEglSurfacelessContext, 3},
    Maker{"egl device, ES 2", gl::createEglDeviceContext, 2},
    Maker{"egl pbuffer, ES 2", gl::createEglPbufferContext, 2},
    Maker{"osmesa", gl::createOsmesaContext, 2},
};

std::vector<TestContext> makeContexts() {
  std::vector<TestContext> made;
  for (const Maker& maker : kMakers) {
    try {
      made.emplace_back(maker.name, maker.make(maker.gles));
    } catch (const Error& error) {
      report("not tested here: {}: {}", maker.name, error.what());
    }
  }
  return made;
}

}  // namespace

TestContext::TestContext(std::string name, std::unique_ptr<gl::Context> context)
    : name_(std::move(name)),
      context_(std::move(context)),
      device_(std::make_unique<gl::Device>(*context_)) {}

TestContext::~TestContext() {
  if (!context_) return;
  context_->makeCurrent();  // the device's objects are deleted in the context that is current
  device_.reset();
}

const std::vector<TestContext>& contexts() {
  static const std::vector<TestContext> kContexts = makeContexts();
  // Without any context the tests would all pass.
  REQUIRE_FALSE(kContexts.empty());
  return kContexts;
}

}  // namespace glimt::test
