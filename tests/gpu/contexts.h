// Every context that can be had on this machine, side by side in one process.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "renderer/gl/device.h"

namespace glimt::test {

class TestContext {
 public:
  TestContext(std::string name, std::unique_ptr<gl::Context> context);
  ~TestContext();
  TestContext(TestContext&&) = default;
  TestContext& operator=(TestContext&&) = delete;

  const std::string& name() const { return name_; }
  gl::Context& context() const { return *context_; }
  bool egl() const { return name_.starts_with("egl"); }
  const gl::Device& device() const { return *device_; }
  int gles() const { return device_->info().gles; }
  const gl::Functions& gl() const { return device_->gl(); }
  void makeCurrent() const { context_->makeCurrent(); }

 private:
  std::string name_;
  std::unique_ptr<gl::Context> context_;
  std::unique_ptr<gl::Device> device_;
};

// Made at the first call. Those that cannot be had are told on standard output.
const std::vector<TestContext>& contexts();

// Calls `test` with every context, made current. What it creates it also destroys.
template <class Test>
void onEveryContext(const Test& test) {
  for (const TestContext& context : contexts()) {
    context.makeCurrent();
    test(context);
  }
}

}  // namespace glimt::test
