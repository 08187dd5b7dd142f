#include "assets/generate/geometry/grid.h"
#include "assets/generate/model/studio_set.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {

void addStudio(Model& model) {
  model.materials["backdrop"].base_color = {0.50, 0.50, 0.505};
  model.materials["backdrop"].roughness = 0.9;
  model.add("backdrop", "backdrop", sweptBackdrop({9, 9, -1.3, 2.4, 6}));
  addSoftBox(model, "overhead light", {5.2, 5.2, 5.2},
             softBox({0, 3.0, 0.3}, {0, 0, 0.3}, 3.4, 1.5));
  addSoftBox(model, "key light", {9.5, 9.0, 8.4}, softBox({4.2, 2.3, 2.4}, {0, 0.6, 0}, 1.5, 2.2));
  addSoftBox(model, "side light", {5.0, 5.3, 5.8},
             softBox({-4.6, 1.7, 3.0}, {0, 0.5, 0}, 1.2, 2.6));
  addSoftBox(model, "edge light", {7.0, 7.2, 7.6},
             softBox({-2.6, 3.0, -1.8}, {-0.3, 0.6, 0}, 2.4, 0.7));
}

void addShopFloor(Model& model) {
  constexpr double kHalf = 20;
  model.materials["floor"] = plain({0.6, 0.6, 0.6}, 0.9);
  model.add("floor", "floor", grid(1, 1, Edges::open, Edges::open, [](int i, int j) {
              return dvec3(i == 0 ? -kHalf : kHalf, 0, j == 0 ? kHalf : -kHalf);
            }));
}

}  // namespace glimt::assets::motorcycle
