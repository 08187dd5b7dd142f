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
      return ContextHandle(way.create(gles));
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
