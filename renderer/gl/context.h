// A GL context and how to get one. Nothing outside this module knows which kind it is.
#pragma once

#include <memory>
#include <string>

#include "renderer/core/context_info.h"
#include "renderer/gl/functions.h"

namespace glimt::gl {

class Context {
 public:
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  virtual void makeCurrent() = 0;

  const Functions& functions() const { return functions_; }
  const ContextInfo& info() const { return info_; }
  bool hasExtension(const std::string& name) const;

 protected:
  Context() = default;

  // Called by a derived class once its context is current.
  void initialize(const std::string& backend, int gles, const ProcLoader& loader);

 private:
  void loadQueries(const ProcLoader& loader);

  Functions functions_;
  ContextInfo info_;
  std::string extensions_;  // separated and enclosed by spaces
};

// The ways to an offscreen context. Each is current on this thread when it comes back.
// `gles` is the major version to ask for. Errors: no_gl.
std::unique_ptr<Context> createEglSurfacelessContext(int gles);
std::unique_ptr<Context> createEglDeviceContext(int gles);
std::unique_ptr<Context> createEglPbufferContext(int gles);
std::unique_ptr<Context> createOsmesaContext(int gles);

// A context that somebody else has made, and keeps current.
std::unique_ptr<Context> adoptContext(const ProcLoader& loader);

}  // namespace glimt::gl
