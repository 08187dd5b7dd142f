// A clear sky with its sun, as a picture of all directions.
#pragma once

#include "renderer/core/image.h"

namespace glimt {

struct SunSky {
  float elevation = 45;  // of the sun above the horizon, degrees in [0, 90]
  float rotation = -40;  // of the sun about +y from +x, degrees, counter-clockwise seen from above
  float turbidity = 3;   // 2: very clear, 10: hazy
};

// Preetham, Shirley and Smits 1999, "A Practical Analytic Model for Daylight": their sky, and their
// sun's transmittance at three wavelengths. Below the horizon is ground that reflects a fifth.
// Radiance 1 is 100,000 lux / pi, the luminance of white paper in bright sunlight. The sun's light
// is right, its disk is as blurred as the picture: about one degree wide.
Image makeSunSky(const SunSky& settings);

}  // namespace glimt
