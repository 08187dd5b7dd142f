// The denoiser's first pass: the picture's light without the colour of what is seen; and in the fourth
// channel the variance of its luminance, or STAYS.
uniform sampler2D uMean;
uniform sampler2D uBlock;
uniform sampler2D uSquares;
uniform sampler2D uSquaresBlock;
uniform float uSpreadKnown;  // 1 where the squares are there and the samples are enough, else 0

// Of the squared luminance: samples that differ by a hundredth differ by the rounding of hit records.
const float ALIKE = 1.0e-4;

// Of a pixel's mean luminance, as if its samples were independent.
float varianceOfMean(float luminance, float square, float samples) {
  float variance = square - luminance * luminance;
  return variance > ALIKE * square ? variance / max(samples - 1.0, 1.0) : 0.0;
}

// What is seen without a surface has no noise, and neither has a pixel whose samples are all alike. One
// that has found no light at all may have had bad luck.
bool stays(float coverage, float luminance, float variance) {
  bool sure = uSpreadKnown > 0.5 && variance == 0.0 && luminance > 0.0;
  return coverage == 0.0 || sure;
}

void main() {
  vec2 at = pictureAddress(pixelCenter());
  vec4 mean = meanWithBlock(texture2D(uMean, at), texture2D(uBlock, at));
  float square = meanWithBlock(texture2D(uSquares, at), texture2D(uSquaresBlock, at)).x;
  Guide guide = fetchGuide(at);
  vec3 own = demodulator(guide);
  float light = luminance(mean.rgb);
  float divided = luminance(mean.rgb / own);
  float scale = divided / max(light, 1.0e-30);
  float variance = varianceOfMean(light, square, mean.w) * scale * scale;
  writeTexel(vec4(mean.rgb / own, stays(guide.coverage, light, variance) ? STAYS : variance));
}
