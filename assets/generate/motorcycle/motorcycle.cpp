#include "assets/generate/motorcycle/motorcycle.h"

#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets {

namespace {

Model onItsWheels() {
  using namespace motorcycle;
  Model model;
  addFinishes(model);
  addWheels(model);
  addBrakes(model);
  addFork(model);
  addFrame(model);
  addSuspension(model);
  addChain(model);
  addEngine(model);
  addIntake(model);
  addExhaust(model);
  addBodywork(model);
  addSeat(model);
  addMudguards(model);
  addHandlebar(model);
  addInstruments(model);
  addLamps(model);
  return model;
}

}  // namespace

Demo makeMotorcycle() {
  Model model = onItsWheels();
  motorcycle::addStudio(model);
  const nlohmann::ordered_json scene = {
      {"camera",
       {{"position", {2.75, 1.15, 4.1}}, {"target", {-0.02, 0.61, 0}}, {"vertical_fov", 18}}},
      {"cameras",
       {{"side", {{"position", {0, 0.95, 6.2}}, {"target", {0, 0.60, 0}}, {"vertical_fov", 14.5}}},
        {"rear",
         {{"position", {-2.9, 1.25, 3.9}}, {"target", {-0.05, 0.58, 0}}, {"vertical_fov", 19.5}}},
        {"engine",
         {{"position", {1.1, 0.9, 2.2}}, {"target", {0.02, 0.50, 0}}, {"vertical_fov", 20}}}}},
      {"environment", {{"color", {0.12, 0.12, 0.125}}}},
      {"render", {{"size", {1280, 720}}, {"bounces", 5}, {"exposure", 0.0}, {"tone", "agx"}}}};
  return {"motorcycle", std::move(model), scene, {}};
}

Demo makeShopMotorcycle() {
  Model model = onItsWheels();
  motorcycle::addShopFloor(model);
  const nlohmann::ordered_json scene = {
      {"camera", {{"position", {0, 1.6, 5.2}}, {"target", {0, 0.55, 0}}, {"vertical_fov", 27}}},
      {"environment", {{"image", "studio"}}},
      {"materials", {{"floor", {{"shadow_catcher", true}}}}},
      {"render",
       {{"size", {512, 512}}, {"bounces", 5}, {"background", "transparent"}, {"tone", "agx"}}}};
  const nlohmann::ordered_json batch = {
      {"output", "shop-motorcycle"},
      {"variants", {"racing green", "signal red", "midnight blue", "cream and orange"}},
      {"turntable", {{"angles", 12}}},
      {"noise", 5}};
  return {"shop-motorcycle", std::move(model), scene, batch};
}

}  // namespace glimt::assets
