// The renderer's own passes, each over the whole picture at once.
#pragma once

#include "renderer/passes/path_tracer.h"

namespace glimt {

inline void drawSample(PathTracer& tracer) {
  const Film& film = tracer.film();
  const double all = static_cast<double>(film.width()) * film.height();
  const int before = tracer.samples();
  while (tracer.samples() == before) tracer.drawTile(all);
}

}  // namespace glimt
