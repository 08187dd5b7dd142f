#include "app/viewer/look.h"

namespace glimt {

Look lookOf(const Scene& scene, const std::string& variant, int bounces, float exposure,
            Tone tone) {
  return {variant,
          scene.materials,
          scene.environment.strength,
          scene.environment.rotation,
          bounces,
          exposure,
          tone};
}

bool sameLight(const Look& a, const Look& b) {
  Look displayed = a;
  displayed.exposure = b.exposure;
  displayed.tone = b.tone;
  return displayed == b;
}

void apply(const Look& look, Scene& scene) {
  scene.materials = look.materials;
  scene.environment.strength = look.environment_strength;
  scene.environment.rotation = look.environment_rotation;
}

}  // namespace glimt
