// The denoiser's pass for pictures of which nobody knows the spread of the samples: the variance of a
// pixel is that of the light of its neighbours on the same surface (Schied et al. 2017, section 4.2).
uniform sampler2D uLight;  // demodulated

void main() {
  vec2 pixel = pixelCenter();
  vec4 own = texture2D(uLight, pictureAddress(pixel));
  Guide guide = fetchGuide(pictureAddress(pixel));
  vec2 slope = depthSlope(pixel, guide.depth);
  float sum = 0.0;
  float squares = 0.0;
  float weights = 0.0;
  for (int y = -3; y <= 3; ++y)
    for (int x = -3; x <= 3; ++x) {
      vec2 offset = vec2(x, y);
      vec2 at = pictureAddress(pixel + offset);
      float light = luminance(texture2D(uLight, at).rgb);
      float weight = isInside(at) ? guideWeight(guide, fetchGuide(at), slope, offset) : 0.0;
      if (x == 0 && y == 0) weight = 1.0;
      sum += weight * light;
      squares += weight * light * light;
      weights += weight;
    }
  float mean = sum / weights;
  float variance = max(squares / weights - mean * mean, 0.0);
  writeTexel(vec4(own.rgb, own.a < 0.0 ? own.a : variance));
}
