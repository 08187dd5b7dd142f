// Where a material is seen, drawn as a line around it.
#pragma once

#include <cstdint>
#include <vector>

#include "app/viewer/loaded_scene.h"

namespace glimt {

struct Outline {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  // rows from the top, transparent but for the line
};

// Traces one ray per pixel of a picture of that size; on any thread.
Outline outlineOf(const LoadedScene& scene, const Camera& camera, std::size_t material, int width,
                  int height, const WorkProgress& progress);

}  // namespace glimt
