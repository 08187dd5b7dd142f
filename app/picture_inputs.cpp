#include "app/picture_inputs.h"

#include "renderer/scene/scene_digest.h"

namespace glimt {

Json inputsOf(const Scene& scene, const RenderSettings& settings) {
  return {{"glimt", GLIMT_VERSION},
          {"scene", digestOf(scene)},
          {"size", {settings.width, settings.height}},
          {"bounces", settings.bounces},
          {"seed", settings.seed},
          {"record", settings.record},
          {"sampler", static_cast<int>(settings.sampler)},
          {"roulette", settings.roulette},
          {"clamp", settings.clamp ? Json(*settings.clamp) : Json()}};
}

}  // namespace glimt
