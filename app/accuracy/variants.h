// What glimt accuracy turns.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "renderer/scene/scene.h"

namespace glimt {

// One way to render the scene.
struct AccuracyVariant {
  std::string knob;     // what is turned, "" for the settings that were asked for
  std::string value;    // to what
  std::string options;  // on the command line of glimt render; "" where there are none
  RenderSettings settings;
  int gles = 2;
  int texture_halvings = 0;           // how often each texture is halved
  std::size_t environment_cells = 0;  // see Environment::most_cells

  std::string name() const { return knob.empty() ? "as asked" : knob + " " + value; }
};

// The settings that were asked for, and then everything that makes a difference in this scene
// turned by itself: bounces, clamp, sampler, record, traversal, and where the scene has them the
// size of the textures and of the environment's table.
std::vector<AccuracyVariant> accuracyVariants(const Scene& scene, const RenderSettings& settings,
                                              int gles);

// Whether one renderer can draw both, with other limits and random numbers at most.
bool shareRenderer(const AccuracyVariant& a, const AccuracyVariant& b);

// The scene as a variant has it.
Scene sceneOf(const AccuracyVariant& variant, const Scene& scene);

}  // namespace glimt
