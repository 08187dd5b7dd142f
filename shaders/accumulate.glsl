// The accumulation pass: the running mean of the samples of each pixel, and how many they are. A
// sample that is not finite, or not known, leaves both as they were.
uniform sampler2D uRadiance;
uniform sampler2D uMean;

// NaN fails every comparison, so the test asks for what is good.
bool isGood(vec3 radiance) {
  float least = min(radiance.r, min(radiance.g, radiance.b));
  float sum = radiance.r + radiance.g + radiance.b;
  return least >= 0.0 && sum <= 1.0e30;
}

void main() {
  vec2 at = pictureAddress(pixelCenter());
  vec3 radiance = texture2D(uRadiance, at).rgb;
  vec4 mean = texture2D(uMean, at);
  float count = mean.a + 1.0;
  vec4 next = vec4(mean.rgb + (radiance - mean.rgb) / count, count);
  writeTexel(isGood(radiance) ? next : mean);
}
