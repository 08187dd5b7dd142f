#include "assets/generate/christmas/christmas.h"

#include "assets/generate/christmas/parts.h"

namespace glimt::assets {

Demo makeChristmas() {
  using namespace christmas;
  Model model;
  addFinishes(model);
  const Tree tree = growTree();
  addTree(model, tree);
  addBaubles(model, tree);
  addLightString(model);
  addStar(model);
  addParcels(model);
  addLanterns(model);
  addFloor(model);
  addWalls(model);
  addWindow(model);
  addLight(model);
  const nlohmann::ordered_json scene = {
      {"camera",
       {{"position", {0.15, 1.28, 4.6}}, {"target", {-0.05, 0.93, 0}}, {"vertical_fov", 31.5}}},
      {"cameras",
       {{"ornaments",
         {{"position", {0.5, 1.15, 1.9}}, {"target", {0.2, 1.0, 0}}, {"vertical_fov", 24}}}}},
      {"environment", {{"color", {0.10, 0.078, 0.055}}}},
      {"render", {{"size", {1280, 720}}, {"bounces", 6}, {"exposure", 0.6}, {"tone", "agx"}}}};
  return {"christmas", std::move(model), scene, {}};
}

}  // namespace glimt::assets
