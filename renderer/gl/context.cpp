#include "renderer/gl/context.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace glimt::gl {
namespace {

class AdoptedContext final : public Context {
 public:
  explicit AdoptedContext(const ProcLoader& loader) { initialize("window", 2, loader); }
  void makeCurrent() override {}
};

std::string text(const Functions& gl, GLenum name) {
  const GLubyte* value = gl.GetString(name);
  return value ? reinterpret_cast<const char*>(value) : "";
}

// Zink is GL over Vulkan, and lavapipe, a Vulkan on the CPU, names llvmpipe in turn.
bool isSoftware(const std::string& renderer) {
  constexpr std::array kNames{"llvmpipe", "softpipe", "swrast", "SwiftShader"};
  return std::any_of(kNames.begin(), kNames.end(),
                     [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

// Extensions by which a context tells that it was lost, and the function under the name it has
// there. Without the extension the name may well be found, but leads to nothing that works.
struct ResetStatusForm {
  const char* extension;
  const char* function;
};
constexpr std::array kResetStatusForms{
    ResetStatusForm{"GL_EXT_robustness", "glGetGraphicsResetStatusEXT"},
    ResetStatusForm{"GL_KHR_robustness", "glGetGraphicsResetStatusKHR"},
    ResetStatusForm{"GL_KHR_robustness", "glGetGraphicsResetStatus"},
    ResetStatusForm{"GL_ARB_robustness", "glGetGraphicsResetStatusARB"},
};

}  // namespace

void Context::initialize(const std::string& backend, int gles, const ProcLoader& loader) {
  functions_ = Functions::load(loader);
  info_.backend = backend;
  info_.renderer = text(functions_, GL_RENDERER);
  info_.version = text(functions_, GL_VERSION);
  info_.gles = gles;
  info_.software = isSoftware(info_.renderer);
  extensions_ = fmt::format(" {} ", text(functions_, GL_EXTENSIONS));
  loadQueries(loader);
  for (const auto& [extension, function] : kResetStatusForms) {
    if (functions_.GetGraphicsResetStatus) break;
    if (hasExtension(extension))
      functions_.GetGraphicsResetStatus =
          reinterpret_cast<decltype(functions_.GetGraphicsResetStatus)>(loader(function));
  }
}

// Questions whether any sample passed are part of ES 3.0; without it, or the extension, the names
// may well be found, too.
void Context::loadQueries(const ProcLoader& loader) {
  const bool by_extension = hasExtension("GL_EXT_occlusion_query_boolean");
  const bool by_version =
      info_.version.starts_with("OpenGL ES 3") || hasExtension("GL_ARB_occlusion_query2");
  if (!by_extension && !by_version) return;
  const std::string suffix = by_extension ? "EXT" : "";
  const auto find = [&](auto& function, const std::string& name) {
    function = reinterpret_cast<std::decay_t<decltype(function)>>(loader((name + suffix).c_str()));
    return function != nullptr;
  };
  const bool complete = find(functions_.DeleteQueries, "glDeleteQueries") &&
                        find(functions_.BeginQuery, "glBeginQuery") &&
                        find(functions_.EndQuery, "glEndQuery") &&
                        find(functions_.GetQueryObjectuiv, "glGetQueryObjectuiv");
  if (complete) find(functions_.GenQueries, "glGenQueries");
}

bool Context::hasExtension(const std::string& name) const {
  return extensions_.find(fmt::format(" {} ", name)) != std::string::npos;
}

std::unique_ptr<Context> adoptContext(const ProcLoader& loader) {
  return std::make_unique<AdoptedContext>(loader);
}

}  // namespace glimt::gl
