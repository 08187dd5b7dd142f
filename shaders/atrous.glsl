// The denoiser's filter: one level of an edge-avoiding a-trous wavelet transform (Dammertz et al. 2010,
// "Edge-avoiding A-Trous wavelet transform for fast global illumination filtering"), whose edges are
// those of the guides, and those of the light as far as they exceed its noise (Schied et al. 2017,
// "Spatiotemporal variance-guided filtering", section 4.4).
uniform sampler2D uLight;  // demodulated; variance of its luminance, or STAYS
uniform float uSpacing;    // pixels between taps

// Standard deviations of the luminance that are no edge yet.
const float LIGHT_TOLERANCE = 4.0;

// A B3 spline.
float splineWeight(float tap) {
  return abs(tap) < 0.5 ? 0.375 : (abs(tap) < 1.5 ? 0.25 : 0.0625);
}

// A variance is known from few samples: its neighbours' make it surer.
float smoothedVariance(vec2 pixel) {
  float sum = 0.0;
  float weights = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      vec2 offset = vec2(x, y);
      vec2 at = pictureAddress(pixel + offset);
      float weight = isInside(at) ? 1.0 / (1.0 + dot(offset, offset)) : 0.0;
      sum += weight * max(texture2D(uLight, at).a, 0.0);
      weights += weight;
    }
  return sum / weights;
}

// By how much the light of two pixels may differ that is the same. Close by the noisier one decides, so
// that rare bright pixels give their light to their neighbours, and the mean stays; farther away the
// pixel itself, so that noisy light does not spill over the edges of shadows.
float deviationOf(float own, float other) {
  float variance = uSpacing < 3.0 ? max(own, other) : own;
  return LIGHT_TOLERANCE * sqrt(variance) + 1.0e-20;
}

// A pixel on an edge shows both sides of it: no other one is like it, but those close by are its parts.
float strictnessOf(Guide guide) {
  return mix(0.05, 1.0, smoothstep(0.9, 1.0, length(guide.normal)));
}

void main() {
  vec2 pixel = pixelCenter();
  vec4 own = texture2D(uLight, pictureAddress(pixel));
  Guide guide = fetchGuide(pictureAddress(pixel));
  vec2 slope = depthSlope(pixel, guide.depth);
  float light = luminance(own.rgb);
  float variance = smoothedVariance(pixel);
  float strictness = uSpacing < 1.5 ? strictnessOf(guide) : 1.0;
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) {
      vec2 offset = vec2(x, y) * uSpacing;
      vec2 at = pictureAddress(pixel + offset);
      vec4 other = texture2D(uLight, at);
      float weight = splineWeight(float(x)) * splineWeight(float(y)) *
                     pow(guideWeight(guide, fetchGuide(at), slope, offset), strictness) *
                     exp(-abs(luminance(other.rgb) - light) /
                         deviationOf(variance, other.a));
      if (x == 0 && y == 0) weight = 0.140625;
      if (!isInside(at)) weight = 0.0;
      sum += vec4(weight * other.rgb, weight * weight * max(other.a, 0.0));
      weights += weight;
    }
  vec4 filtered = vec4(sum.rgb / weights, sum.a / (weights * weights));
  writeTexel(own.a < 0.0 ? own : filtered);
}
