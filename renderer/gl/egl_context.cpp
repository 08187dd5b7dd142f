// Offscreen contexts through EGL: without any surface, on a device, or with a one-pixel pbuffer.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "renderer/core/error.h"
#include "renderer/gl/context.h"
#include "renderer/gl/shared_library.h"

namespace glimt::gl {
namespace {

struct Egl {
  SharedLibrary library{"libEGL.so.1"};
  decltype(&eglGetProcAddress) getProcAddress =
      require<decltype(&eglGetProcAddress)>("eglGetProcAddress");
  decltype(&eglQueryString) queryString = require<decltype(&eglQueryString)>("eglQueryString");
  decltype(&eglGetError) getError = require<decltype(&eglGetError)>("eglGetError");
  decltype(&eglGetDisplay) getDisplay = require<decltype(&eglGetDisplay)>("eglGetDisplay");
  decltype(&eglInitialize) initialize = require<decltype(&eglInitialize)>("eglInitialize");
  decltype(&eglTerminate) terminate = require<decltype(&eglTerminate)>("eglTerminate");
  decltype(&eglBindAPI) bindApi = require<decltype(&eglBindAPI)>("eglBindAPI");
  decltype(&eglChooseConfig) chooseConfig = require<decltype(&eglChooseConfig)>("eglChooseConfig");
  decltype(&eglCreateContext) createContext =
      require<decltype(&eglCreateContext)>("eglCreateContext");
  decltype(&eglDestroyContext) destroyContext =
      require<decltype(&eglDestroyContext)>("eglDestroyContext");
  decltype(&eglCreatePbufferSurface) createPbuffer =
      require<decltype(&eglCreatePbufferSurface)>("eglCreatePbufferSurface");
  decltype(&eglDestroySurface) destroySurface =
      require<decltype(&eglDestroySurface)>("eglDestroySurface");
  decltype(&eglGetCurrentContext) getCurrentContext =
      require<decltype(&eglGetCurrentContext)>("eglGetCurrentContext");
  decltype(&eglMakeCurrent) makeCurrent = require<decltype(&eglMakeCurrent)>("eglMakeCurrent");

  template <class Function>
  Function extension(const char* name) const {
    return reinterpret_cast<Function>(getProcAddress(name));
  }

  [[noreturn]] void fail(const std::string& call) const {
    throw Error(ErrorKind::no_gl, fmt::format("{} failed (EGL error 0x{:x})", call, getError()));
  }

 private:
  template <class Function>
  Function require(const char* name) const {
    return library.require<Function>(name);
  }
};

enum class Surface { none, pbuffer };

class EglContext final : public Context {
 public:
  EglContext(Egl egl, EGLDisplay display, Surface surface, const std::string& backend, int gles)
      : egl_(std::move(egl)), display_(display) {
    if (!egl_.initialize(display_, nullptr, nullptr)) egl_.fail("eglInitialize");
    try {
      create(surface, gles);
      makeCurrent();
      initialize(backend, gles, [this](const char* name) {
        return reinterpret_cast<void*>(egl_.getProcAddress(name));
      });
    } catch (...) {
      destroy();
      throw;
    }
  }

  ~EglContext() override { destroy(); }

  void makeCurrent() override {
    if (!egl_.makeCurrent(display_, surface_, surface_, context_)) egl_.fail("eglMakeCurrent");
  }

 private:
  void create(Surface surface, int gles) {
    if (!egl_.bindApi(EGL_OPENGL_ES_API)) egl_.fail("eglBindAPI");
    const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE,
                                       surface == Surface::pbuffer ? EGL_PBUFFER_BIT : 0,
                                       EGL_RENDERABLE_TYPE, EGL_OPENGL_ES2_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!egl_.chooseConfig(display_, wanted.data(), &config, 1, &count) || count == 0)
      egl_.fail("eglChooseConfig");
    createContext(config, gles);
    if (surface == Surface::pbuffer) {
      const std::array<EGLint, 5> size{EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
      surface_ = egl_.createPbuffer(display_, config, size.data());
      if (surface_ == EGL_NO_SURFACE) egl_.fail("eglCreatePbufferSurface");
    }
  }

  // Where it can be had, one that tells when it is lost. It is not worth failing for.
  void createContext(EGLConfig config, int gles) {
    const std::array<EGLint, 5> telling{EGL_CONTEXT_CLIENT_VERSION, gles,
                                        EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT,
                                        EGL_LOSE_CONTEXT_ON_RESET_EXT, EGL_NONE};
    const std::array<EGLint, 3> plain{EGL_CONTEXT_CLIENT_VERSION, gles, EGL_NONE};
    const char* const extensions = egl_.queryString(display_, EGL_EXTENSIONS);
    if (extensions && std::strstr(extensions, "EGL_EXT_create_context_robustness"))
      context_ = egl_.createContext(display_, config, EGL_NO_CONTEXT, telling.data());
    if (context_ == EGL_NO_CONTEXT)
      context_ = egl_.createContext(display_, config, EGL_NO_CONTEXT, plain.data());
    if (context_ == EGL_NO_CONTEXT) egl_.fail("eglCreateContext");
  }

  void destroy() {
    // Another context may have become current since: that one stays.
    if (egl_.getCurrentContext() == context_)
      egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface_ != EGL_NO_SURFACE) egl_.destroySurface(display_, surface_);
    if (context_ != EGL_NO_CONTEXT) egl_.destroyContext(display_, context_);
    // The display itself is shared by everyone in the process who asks for the same one, so it is
    // not terminated here.
  }

  Egl egl_;
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
  EGLSurface surface_ = EGL_NO_SURFACE;
};

EGLDisplay platformDisplay(const Egl& egl, EGLenum platform, void* native) {
  const auto get = egl.extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  return get ? get(platform, native, nullptr) : EGL_NO_DISPLAY;
}

}  // namespace

std::unique_ptr<Context> createEglSurfacelessContext(int gles) {
  Egl egl;
  const EGLDisplay display =
      platformDisplay(egl, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  if (display == EGL_NO_DISPLAY) egl.fail("eglGetPlatformDisplayEXT(surfaceless)");
  return std::make_unique<EglContext>(std::move(egl), display, Surface::none, "egl surfaceless",
                                      gles);
}

std::unique_ptr<Context> createEglDeviceContext(int gles) {
  Egl egl;
  const auto query = egl.extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (!query || !query(devices.size(), devices.data(), &count) || count == 0)
    egl.fail("eglQueryDevicesEXT");
  std::string reasons;
  for (EGLint i = 0; i < count; ++i) {
    try {
      const EGLDisplay display = platformDisplay(egl, EGL_PLATFORM_DEVICE_EXT, devices[i]);
      if (display == EGL_NO_DISPLAY) egl.fail("eglGetPlatformDisplayEXT(device)");
      return std::make_unique<EglContext>(Egl(), display, Surface::none, "egl device", gles);
    } catch (const Error& error) {
      reasons += fmt::format("{}device {}: {}", i ? ", " : "", i, error.what());
    }
  }
  throw Error(ErrorKind::no_gl, reasons);
}

std::unique_ptr<Context> createEglPbufferContext(int gles) {
  Egl egl;
  const EGLDisplay display = egl.getDisplay(EGL_DEFAULT_DISPLAY);
  if (display == EGL_NO_DISPLAY) egl.fail("eglGetDisplay");
  return std::make_unique<EglContext>(std::move(egl), display, Surface::pbuffer, "egl pbuffer",
                                      gles);
}

}  // namespace glimt::gl
