#include "assets/generate/watch/watch.h"

#include <algorithm>
#include <limits>

#include "assets/generate/watch/parts.h"

namespace glimt::assets {
namespace {

// Leans back so that the dial looks at the customer, and stands on y = 0.
void stand(Model& model) {
  double lowest = std::numeric_limits<double>::max();
  for (Part& part : model.parts) {
    part.mesh = transformed(part.mesh, turned(-14, {0, 1, 0}) * turned(50, {1, 0, 0}));
    for (const dvec3& p : part.mesh.positions) lowest = std::min(lowest, p.y);
  }
  for (Part& part : model.parts) part.mesh = transformed(part.mesh, moved({0, -lowest, 0}));
}

}  // namespace

Demo makeWatch() {
  using namespace watch;
  Model model;
  addFinishes(model);
  addCase(model);
  addBezel(model);
  addDial(model);
  addHands(model);
  addStrap(model);
  addCushion(model);
  stand(model);
  addTable(model);
  const nlohmann::ordered_json scene = {
      {"camera",
       {{"position", {0.03, 0.17, 0.33}}, {"target", {0.0, 0.034, 0}}, {"vertical_fov", 13}}},
      {"environment", {{"color", {0.16, 0.16, 0.165}}}},
      {"render", {{"size", {1280, 720}}, {"bounces", 5}, {"exposure", 0.0}, {"tone", "agx"}}}};
  return {"watch", std::move(model), scene, {}};
}

}  // namespace glimt::assets
