// Many triangles in one place: a tree over them is of no use.
#pragma once

#include "renderer/scene/scene.h"

namespace glimt::test {

// In front of the default camera, under a white environment.
inline Scene coincidentTriangles(std::size_t count) {
  Scene scene;
  scene.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  scene.materials.resize(1);
  scene.environment.color = Vec3(1);
  Triangle triangle;
  triangle.positions = {0, 1, 2};
  scene.triangles.assign(count, triangle);
  return scene;
}

}  // namespace glimt::test
