// A photographer's studio: paper that sweeps up behind the product, and soft boxes.
#pragma once

#include <string>

#include "assets/generate/model/model.h"

namespace glimt::assets {

struct BackdropSize {
  double half_width;
  double front;   // the floor's edge, towards +z
  double bend;    // where the floor begins to rise
  double radius;  // of the bend
  double top;     // of the wall
};

// Floor, a quarter of a cylinder, wall.
Mesh sweptBackdrop(const BackdropSize& size);

// A rectangle at `at` whose front looks at `target`.
Mesh softBox(const dvec3& at, const dvec3& target, double width, double height);

// Adds the rectangle, and its material of the same name.
void addSoftBox(Model& model, const std::string& name, const dvec3& radiance, const Mesh& box);

}  // namespace glimt::assets
