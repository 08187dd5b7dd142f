#pragma once

#include <string>
#include <vector>

#include "renderer/core/effects.h"
#include "renderer/scene/scene.h"

namespace glimt {

struct EffectReport {
  Effect effect;
  std::string name;  // as in the command line's output: "triangle_lights"
  bool on = false;
  std::string reason;  // why it is on, or why it is off: "2 triangles emit"
};

// Every effect there is, on or off. Depends on the scene alone.
std::vector<EffectReport> reportEffects(const Scene& scene);

EffectSet effectsOf(const Scene& scene);

// The same for the scene with another camera.
EffectSet withCamera(EffectSet effects, const Camera& camera);

// These, and what they call for besides, as in any scene: pictures that bend normals are pictures.
// Of a lens and a parallel projection, the latter.
EffectSet withImplied(EffectSet effects);

// Without the parallel projection, which takes another's place, and what the background brings:
// they make another picture, so that they are neither forced nor withheld.
EffectSet changeable(EffectSet effects);

// Those of a scene, and changeable ones that no part of it calls for. A lens is not forced upon a
// parallel projection.
EffectSet withForced(const EffectSet& effects, const EffectSet& forced);

// Those of a scene but for some, and but for those that imply them.
EffectSet without(const EffectSet& effects, const EffectSet& withheld);

// What is drawn otherwise than a scene calls for, to tell what effects cost.
struct EffectChange {
  EffectSet forced;
  EffectSet withheld;
};

EffectSet changed(const EffectSet& effects, const EffectChange& change);

}  // namespace glimt
