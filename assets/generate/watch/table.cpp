#include "assets/generate/model/studio_set.h"
#include "assets/generate/watch/parts.h"

namespace glimt::assets::watch {

void addTable(Model& model) {
  model.materials["paper"].base_color = {0.30, 0.29, 0.275};
  model.materials["paper"].roughness = 0.9;
  model.add("paper", "paper", sweptBackdrop({1.2, 0.9, -0.16, 0.30, 0.9}));
  const dvec3 watch(0, 0.03, 0);
  addSoftBox(model, "top light", {4.6, 4.6, 4.6}, softBox({-0.05, 0.62, -0.30}, watch, 0.85, 0.45));
  addSoftBox(model, "window", {4.4, 4.5, 4.8}, softBox({-0.62, 0.34, 0.10}, watch, 0.45, 0.60));
  addSoftBox(model, "strip", {5.4, 5.1, 4.7}, softBox({0.60, 0.26, 0.02}, watch, 0.16, 0.60));
}

}  // namespace glimt::assets::watch
