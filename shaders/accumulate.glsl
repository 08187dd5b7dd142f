// The accumulation pass: radiance to the sum of the samples of this block, by blending, or where
// the device cannot blend floats by reading what is there. A sample that is not finite, or not known,
// leaves the sum and its count as they were. The composer defines ACCUMULATED, what of a sample is summed.
uniform sampler2D uRadiance;
#if !ADDITIVE_BLENDING
uniform sampler2D uBlock;
#endif

void main() {
  vec2 at = pictureAddress(pixelCenter());
  vec3 radiance = ACCUMULATED(texture2D(uRadiance, at));
#if CLAMP
  if (isGoodSample(radiance)) radiance = clampedSample(radiance);
#endif
  vec4 sum = sampleForBlock(radiance);
#if !ADDITIVE_BLENDING
  sum += texture2D(uBlock, at);
#endif
  writeTexel(sum);
}
