// Surfaces that are drawn, not modelled: normal maps of repeating reliefs.
#pragma once

#include <functional>
#include <string>

#include "assets/generate/model/model.h"

namespace glimt::assets {

// A tile of `side` x `side` pixels: height(u, v), u and v in [0, 1), repeats; in units of the
// tile's side. Green points up in the picture, as glTF has it.
Picture normalMap(const std::string& name, int side,
                  const std::function<double(double, double)>& height);

// Over and under: `threads` of them (an even number) in each direction.
double wovenHeight(double u, double v, int threads);

// The grain of leather: cells with rounded tops, about `cells` across.
double grainHeight(double u, double v, int cells);

}  // namespace glimt::assets
