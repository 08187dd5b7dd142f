// Which way to a context is tried first.
#include <fmt/format.h>

#include <functional>
#include <vector>

#include "renderer/core/error.h"
#include "renderer/gl/context.h"
#include "renderer/renderer.h"

namespace glimt {
namespace {

struct Way {
  const char* name;
  Backend backend;
  std::function<std::unique_ptr<gl::Context>(int gles)> create;
};

const std::vector<Way>& ways() {
  static const std::vector<Way> kWays{
      {"EGL surfaceless", Backend::egl, gl::createEglSurfacelessContext},
      {"EGL device", Backend::egl, gl::createEglDeviceContext},
      {"EGL pbuffer", Backend::egl, gl::createEglPbufferContext},
      {"OSMesa", Backend::osmesa, gl::createOsmesaContext},
  };
  return kWays;
}

// A rasteriser in software is used only where no device is there: without a display, a GPU is often
// found by its device alone.
std::unique_ptr<gl::Context> preferDevice(std::unique_ptr<gl::Context> context, int gles) {
  if (!context->info().software) return context;
  try {
    auto device = gl::createEglDeviceContext(gles);
    if (!device->info().software) {
      context.reset();
      device->makeCurrent();
      return device;
    }
  } catch (const Error&) {  // then software it is
  }
  context->makeCurrent();
  return context;
}

}  // namespace

ContextHandle::ContextHandle(std::unique_ptr<gl::Context> context) : context_(std::move(context)) {}
ContextHandle::ContextHandle(ContextHandle&&) noexcept = default;
ContextHandle& ContextHandle::operator=(ContextHandle&&) noexcept = default;
ContextHandle::~ContextHandle() = default;

ContextInfo ContextHandle::info() const {
  return context_->info();
}

ContextHandle createOffscreenContext(Backend backend, int gles) {
  std::string reasons;
  for (const Way& way : ways()) {
    if (backend != Backend::automatic && backend != way.backend) continue;
    try {
      auto context = way.create(gles);
      if (way.backend == Backend::egl) context = preferDevice(std::move(context), gles);
      return ContextHandle(std::move(context));
    } catch (const Error& error) {
      reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", way.name, error.what());
    }
  }
  throw Error(ErrorKind::no_gl, fmt::format("no usable GL ({}); install Mesa's drivers (Debian: "
                                            "libegl1 libgl1-mesa-dri, or libosmesa6)",
                                            reasons));
}

ContextHandle adoptCurrentContext(const ProcLoader& load) {
  return ContextHandle(gl::adoptContext(load));
}

}  // namespace glimt
