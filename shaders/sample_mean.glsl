// The mean of the samples of a pixel, kept in two parts: a block is the sum of up to
// SAMPLES_PER_BLOCK samples, and the mean is of the blocks before it. The fourth channel of each
// counts its samples. A running mean alone would drift: its late updates are so small that each is
// rounded to a few units of its last place.

// NaN fails every comparison, so the test asks for what is good.
bool isGoodSample(vec3 radiance) {
  float least = min(radiance.x, min(radiance.y, radiance.z));
  float sum = radiance.x + radiance.y + radiance.z;
  return least >= 0.0 && sum <= 1.0e30;
}

// What a sample adds to its block: nothing, where it is not finite or not known.
vec4 sampleForBlock(vec3 radiance) {
  return isGoodSample(radiance) ? vec4(radiance, 1.0) : vec4(0.0);
}

// The mean with a block added to it.
vec4 meanWithBlock(vec4 mean, vec4 block) {
  float count = mean.w + block.w;
  vec3 before = vec3(mean.x, mean.y, mean.z);
  vec3 sum = vec3(block.x, block.y, block.z);
  return vec4(before + (sum - block.w * before) / max(count, 1.0), count);
}
