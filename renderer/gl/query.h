// Whether a draw did anything: occlusion queries.
#pragma once

#include "renderer/gl/handle.h"

namespace glimt::gl {

class Query {
 public:
  // One that asks nothing where the context has no queries: an answer is always yes.
  Query() = default;
  explicit Query(const Functions& gl);

  // Draws between the two are asked about, at least one. Queries do not overlap.
  void begin() const;
  void end() const;

  // Whether any pixel of them passed the stencil. Waits for the draws.
  bool anyPassed() const;

  // Whether an answer can be no.
  explicit operator bool() const { return static_cast<bool>(handle_); }

 private:
  QueryHandle handle_;
};

}  // namespace glimt::gl
