// Offscreen contexts through OSMesa: Mesa's software rasteriser behind a plain function call, for
// machines on which EGL finds no driver at all.
#include <fmt/format.h>

#include <vector>

#include "renderer/core/error.h"
#include "renderer/gl/context.h"
#include "renderer/gl/shared_library.h"

namespace glimt::gl {
namespace {

// From Mesa's osmesa.h, which cannot be included: it drags in the desktop GL header.
using OsmesaContextPointer = void*;
using CreateContextAttribs = OsmesaContextPointer (*)(const int* attributes, OsmesaContextPointer);
using DestroyContext = void (*)(OsmesaContextPointer);
using MakeCurrent = GLboolean (*)(OsmesaContextPointer, void* buffer, GLenum type, GLsizei width,
                                  GLsizei height);
using GetProcAddress = void* (*)(const char*);
constexpr int kOsmesaFormat = 0x22;
constexpr int kOsmesaProfile = 0x33;
constexpr int kOsmesaCompatProfile = 0x35;
constexpr int kOsmesaRgba = 0x1908;

class OsmesaContext final : public Context {
 public:
  explicit OsmesaContext(int gles)
      : create_(library_.require<CreateContextAttribs>("OSMesaCreateContextAttribs")),
        destroy_(library_.require<DestroyContext>("OSMesaDestroyContext")),
        make_current_(library_.require<MakeCurrent>("OSMesaMakeCurrent")) {
    const int attributes[] = {kOsmesaFormat, kOsmesaRgba, kOsmesaProfile, kOsmesaCompatProfile, 0};
    context_ = create_(attributes, nullptr);
    if (!context_) throw Error(ErrorKind::no_gl, "OSMesaCreateContextAttribs failed");
    try {
      makeCurrent();
      const auto get = library_.require<GetProcAddress>("OSMesaGetProcAddress");
      initialize("osmesa", gles, get);
      const std::string extension = fmt::format("GL_ARB_ES{}_compatibility", gles);
      if (!hasExtension(extension)) throw Error(ErrorKind::no_gl, "OSMesa has no " + extension);
    } catch (...) {
      destroy_(context_);
      throw;
    }
  }

  ~OsmesaContext() override { destroy_(context_); }

  void makeCurrent() override {
    if (!make_current_(context_, pixels_.data(), GL_UNSIGNED_BYTE, 1, 1))
      throw Error(ErrorKind::no_gl, "OSMesaMakeCurrent failed");
  }

 private:
  SharedLibrary library_{"libOSMesa.so.8"};
  CreateContextAttribs create_;
  DestroyContext destroy_;
  MakeCurrent make_current_;
  OsmesaContextPointer context_ = nullptr;
  std::vector<unsigned char> pixels_ = std::vector<unsigned char>(4);  // OSMesa insists on a buffer
};

}  // namespace

std::unique_ptr<Context> createOsmesaContext(int gles) {
  return std::make_unique<OsmesaContext>(gles);
}

}  // namespace glimt::gl
